/// Frictional contact of linear elastic bodies in the plane.
///
///   epafi run SCENE.xml           solve: a table row per level, files into a folder
///   epafi --help                  all commands (drivers/commands/CommandTable.cpp)
///
/// Sample run:  epafi run drivers/scenes/tresca.xml --set 'Adaptivity->Maximum Levels=3'

#include "drivers/Program.hpp"

int main(int argc, char* argv[]) { return epafi::program(argc, argv); }
