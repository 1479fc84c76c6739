// One function of each component.
#include "adaptivity/mark/Strategy.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/law/FrictionLaw.hpp"

#include <cstdio>

int main() {
  std::printf("%d\n", epafi::bem::gaussLegendre(3).size());
  std::printf("%g\n", epafi::contact::PointLaw(0.5).bound(2));
  return epafi::adaptivity::strategies().at("Uniform h").name == nullptr ? 1 : 0;
}
