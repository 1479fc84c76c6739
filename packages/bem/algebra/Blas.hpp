#pragma once

// The few BLAS and LAPACK routines in use, by their Fortran names.
extern "C" {
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dpotrs_(const char* uplo, const int* n, const int* nrhs, const double* a,
             const int* lda, double* b, const int* ldb, int* info);
// rectangular full packed triangles
void dpftrs_(const char* transr, const char* uplo, const int* n, const int* nrhs,
             const double* packed, double* b, const int* ldb, int* info);
void dtfsm_(const char* transr, const char* side, const char* uplo, const char* trans,
            const char* diag, const int* m, const int* n, const double* alpha,
            const double* packed, double* b, const int* ldb);
void dtrtri_(const char* uplo, const char* diag, const int* n, double* a, const int* lda,
             int* info);
void dgesv_(const int* n, const int* nrhs, double* a, const int* lda, int* pivots,
            double* b, const int* ldb, int* info);
void dtrsm_(const char* side, const char* uplo, const char* trans, const char* diag,
            const int* m, const int* n, const double* alpha, const double* a,
            const int* lda, double* b, const int* ldb);
void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* beta,
            double* c, const int* ldc);
void dgemm_(const char* transa, const char* transb, const int* m, const int* n,
            const int* k, const double* alpha, const double* a, const int* lda,
            const double* b, const int* ldb, const double* beta, double* c,
            const int* ldc);
void dgemv_(const char* trans, const int* m, const int* n, const double* alpha,
            const double* a, const int* lda, const double* x, const int* incx,
            const double* beta, double* y, const int* incy);
void dsymv_(const char* uplo, const int* n, const double* alpha, const double* a,
            const int* lda, const double* x, const int* incx, const double* beta,
            double* y, const int* incy);
void dsyev_(const char* jobz, const char* uplo, const int* n, double* a, const int* lda,
            double* w, double* work, const int* lwork, int* info);
void dgesvd_(const char* jobu, const char* jobvt, const int* m, const int* n, double* a,
             const int* lda, double* s, double* u, const int* ldu, double* vt,
             const int* ldvt, double* work, const int* lwork, int* info);
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* pivots,
             int* info);
void dgetrs_(const char* trans, const int* n, const int* nrhs, const double* a,
             const int* lda, const int* pivots, double* b, const int* ldb, int* info);
void dgeqrt_(const int* m, const int* n, const int* nb, double* a, const int* lda,
             double* t, const int* ldt, double* work, int* info);
void dgeqp3_(const int* m, const int* n, double* a, const int* lda, int* jpvt,
             double* tau, double* work, const int* lwork, int* info);
}
