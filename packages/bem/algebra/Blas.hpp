#pragma once

// BLAS and LAPACK functions that Teuchos does not wrap, by their Fortran names.
extern "C" {
// rectangular full packed triangles
void dpftrs_(const char* transr, const char* uplo, const int* n, const int* nrhs,
             const double* packed, double* b, const int* ldb, int* info);
void dtfsm_(const char* transr, const char* side, const char* uplo, const char* trans,
            const char* diag, const int* m, const int* n, const double* alpha,
            const double* packed, double* b, const int* ldb);
void dsymv_(const char* uplo, const int* n, const double* alpha, const double* a,
            const int* lda, const double* x, const int* incx, const double* beta,
            double* y, const int* incy);
void dgeqrt_(const int* m, const int* n, const int* nb, double* a, const int* lda,
             double* t, const int* ldt, double* work, int* info);
}
