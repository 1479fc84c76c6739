#include "Processes.hpp"

const epafi::bem::Processes& epafi::test::processes() { return bem::oneProcess(); }
