#include "bem/tractions/TractionRows.hpp"

namespace epafi::bem {

std::shared_ptr<const TractionRows> tractionRows(const Space& space, const Lame& lame,
                                                 const SteklovPoincare& stiffness,
                                                 const std::vector<int>& elements,
                                                 TractionForm form) {
  if (form == TractionForm::Projected && stiffness.tractionElements() == elements)
    return stiffness.tractions();
  std::vector<int> moments;
  for (const int e : elements)
    moments.push_back(space.mesh()[e].degree + 1);
  KernelRows kernels = kernelRows(space, lame, elements, moments, form);
  return std::make_shared<const TractionRows>(
      TractionRows{stiffness.addAdjointDensity(std::move(kernels.hypersingular),
                                               std::move(kernels.adjoint)),
                   std::move(kernels.start)});
}

}  // namespace epafi::bem
