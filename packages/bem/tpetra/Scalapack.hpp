#pragma once

#include <mpi.h>

// The few routines of BLACS, PBLAS and ScaLAPACK in use; Debian ships no headers.
extern "C" {
int Csys2blacs_handle(MPI_Comm comm);
void Cfree_blacs_system_handle(int handle);
void Cblacs_gridinit(int* context, const char* order, int rows, int columns);
void Cblacs_gridinfo(int context, int* rows, int* columns, int* row, int* column);
void Cblacs_gridexit(int context);
int numroc_(const int* n, const int* block, const int* me, const int* source,
            const int* processes);
void descinit_(int* descriptor, const int* m, const int* n, const int* mb, const int* nb,
               const int* rowSource, const int* columnSource, const int* context,
               const int* lld, int* info);
void pdgemr2d_(const int* m, const int* n, const double* a, const int* ia, const int* ja,
               const int* desca, double* b, const int* ib, const int* jb,
               const int* descb, const int* context);
void pdpotrf_(const char* uplo, const int* n, double* a, const int* ia, const int* ja,
              const int* desca, int* info);
void pdpotrs_(const char* uplo, const int* n, const int* nrhs, const double* a,
              const int* ia, const int* ja, const int* desca, double* b, const int* ib,
              const int* jb, const int* descb, int* info);
void pdtrsm_(const char* side, const char* uplo, const char* trans, const char* diag,
             const int* m, const int* n, const double* alpha, const double* a,
             const int* ia, const int* ja, const int* desca, double* b, const int* ib,
             const int* jb, const int* descb);
}
