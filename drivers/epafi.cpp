/// Frictional contact of linear elastic bodies in the plane.
///
///   epafi run SCENE.xml           solve: a table row per level, files into a folder
///   epafi study STUDY.xml         run variants of scenes and compare them
///   epafi check SCENE.xml         read and validate only
///   epafi parameters              every parameter of a scene
///   epafi plot DIR                pictures of a finished run or study
///   epafi version | --help
///
/// Sample run:  epafi run drivers/scenes/tresca.xml --set 'Adaptivity->Maximum Levels=3'

#include "drivers/Program.hpp"

int main(int argc, char* argv[]) { return epafi::program(argc, argv); }
