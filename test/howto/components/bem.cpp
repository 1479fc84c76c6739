#include "bem/base/Material.hpp"

int main() { return epafi::bem::Lame({5, 0.45, false}).mu > 0 ? 0 : 1; }
