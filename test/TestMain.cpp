// Every suite of unit tests starts here: no MPI, which makes them quick.
#include <Teuchos_UnitTestRepository.hpp>

int main(int argc, char* argv[]) {
  return Teuchos::UnitTestRepository::runUnitTestsFromMain(argc, argv);
}
