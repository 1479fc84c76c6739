#include "drivers/run/Stiffness.hpp"

#include "bem/operators/ExactRotation.hpp"
#include "contact/compressed/CompressedStiffness.hpp"

namespace epafi::drivers {

namespace {

std::vector<bem::SteklovPoincare> compressedStiffness(const Scene& scene,
                                                      const BodySpaces& spaces,
                                                      const bem::Processes& processes) {
  std::vector<bem::Lame> lames;
  for (std::size_t b = 0; b < spaces.size(); ++b)
    lames.push_back(scene.lame(b));
  return contact::makeCompressedStiffness(spaces.sides(), lames, scene.stabilization,
                                          scene.units(), processes,
                                          scene.linear.compression);
}

bem::Operators denseOperators(const Scene& scene, const BodySpaces& spaces,
                              std::size_t b) {
  const bem::Space& space = spaces.space(b);
  return bem::withExactRotation(
      bem::assembleOperators(
          space, scene.lame(b),
          contact::tractionElements(spaces.multiplier(b), scene.stabilization)),
      space);
}

}  // namespace

std::vector<bem::SteklovPoincare> makeStiffness(const Scene& scene,
                                                const BodySpaces& spaces, bool compressed,
                                                const bem::SingleLayerSolver* krylov,
                                                const bem::Processes& processes,
                                                PhaseTimer& timer) {
  if (compressed)
    return timer.run(Phase::Factorization,
                     [&] { return compressedStiffness(scene, spaces, processes); });
  std::vector<bem::Operators> operators = timer.run(Phase::Assembly, [&] {
    std::vector<bem::Operators> all;
    for (std::size_t b = 0; b < spaces.size(); ++b)
      all.push_back(denseOperators(scene, spaces, b));
    return all;
  });
  return timer.run(Phase::Factorization, [&] {
    std::vector<bem::SteklovPoincare> all;
    for (std::size_t b = 0; b < spaces.size(); ++b) {
      const bem::LocalCompliance compliance =
          contact::densityCompliance(spaces.space(b), spaces.multiplier(b),
                                     scene.stabilization, scene.lame(b), scene.units());
      all.push_back(
          krylov != nullptr
              ? bem::SteklovPoincare(std::move(operators[b]), *krylov, compliance)
              : bem::SteklovPoincare(std::move(operators[b]), compliance));
    }
    return all;
  });
}

}  // namespace epafi::drivers
