#pragma once

namespace epafi {

/// The program epafi: `argv` as its main gets it; returns the exit code.
///
/// For programs of one's own: whatever they add to families (contact::frictionLaws() and
/// the like) before they call it, scenes can name, and commands list and check.
/// Starts and ends MPI and Kokkos; once per process.
int program(int argc, char* argv[]);

}  // namespace epafi
