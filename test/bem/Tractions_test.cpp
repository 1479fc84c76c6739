#include "Largest.hpp"
#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/operators/ExactRotation.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tractions/TractionRows.hpp"
#include "reference/ExactFields.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace epafi {

namespace {

using bem::Index;
using bem::Matrix;
using bem::Vec2;
using bem::Vector;
using test::largest;

std::vector<int> allElements(const bem::Mesh& mesh) {
  std::vector<int> elements(mesh.size());
  std::iota(elements.begin(), elements.end(), 0);
  return elements;
}

/// Of <S φ, φ_k>, relative to the largest: entries of S, and what the projected tractions on all
/// elements give.  Legendre coefficients of φ_k are exact to its degree.
double differenceFromStiffness(const bem::Space& space, const bem::Lame& lame) {
  const bem::Mesh& mesh = space.mesh();
  const bem::SteklovPoincare stiffness(bem::assembleOperators(space, lame));
  const auto tractions = bem::tractionRows(space, lame, stiffness, allElements(mesh),
                                           bem::TractionForm::Projected);
  const Index n = space.displacements();
  Matrix tested(n, n);  // by φ_k, and the displacements
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Element& element = mesh[e];
    const Matrix legendre = bem::DisplacementBasis::legendreCoefficients(element.degree);
    for (int k = 0; k <= element.degree; ++k)
      for (int i = 0; i <= element.degree; ++i)
        for (int c = 0; c < 2; ++c) {
          const double* column = tractions->rows.column(tractions->start[e] + 2 * i + c);
          const double factor =
              legendre(i, k) * std::sqrt(2 * element.half / (2 * i + 1));
          for (Index j = 0; j < n; ++j)
            tested(space.displacement(e, k, c), j) += factor * column[j];
        }
  }
  if (space.rotation() != nullptr)
    tested = bem::withoutRotation(std::move(tested), *space.rotation());
  std::vector<Index> all(static_cast<std::size_t>(n));
  std::iota(all.begin(), all.end(), Index{0});
  const Vector columns = stiffness.stiffness().columns(all);
  double error = 0;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      error = std::max(error, std::abs(tested(i, j) - columns[bem::at(j * n + i)]));
  return error / largest(columns);
}

TEUCHOS_UNIT_TEST(ProjectedTractions, testedByDisplacementsAreTheStiffness) {
  for (const double nu : {0.3, -0.4})
    for (const auto& sample : reference::hardSamples()) {
      out << sample.name << ": ";
      TEST_COMPARE(
          differenceFromStiffness(bem::Space(sample.mesh), bem::Lame({1, nu, false})), <,
          2e-12);
    }
}

TEUCHOS_UNIT_TEST(ProjectedTractions, onArcsDoNotFeelTheRotation) {
  for (const auto& loop : {reference::disc(3, 0.5), reference::curvedSample()}) {
    const auto outline = test::outlineOf(loop);
    const bem::Space space(
        bem::makeMesh(outline, std::vector<int>(outline->edges().size(), 2), 5));
    TEST_COMPARE(differenceFromStiffness(space, bem::Lame({1, 0.3, false})), <, 2e-12);
  }
}

// ∫ S u · S u ds from the orthonormal columns against the square of the exact traction.
TEUCHOS_UNIT_TEST(ExactTractions, ofAConstantStressHaveItsNorm) {
  const bem::Lame lame(bem::Material{1, 0.3, false});
  const auto field = reference::constantStress(lame, {0.4, -0.3, 0.2}, 0.7);
  for (const auto& sample : reference::quickSamples()) {
    const bem::Space space(sample.mesh);
    const std::vector<int> elements = allElements(sample.mesh);
    const bem::SteklovPoincare stiffness(bem::assembleOperators(space, lame));
    const Vector u = reference::displacementOf(space, field);
    for (const auto form : {bem::TractionForm::Projected, bem::TractionForm::Exact}) {
      const auto rows = bem::tractionRows(space, lame, stiffness, elements, form);
      for (std::size_t k = 0; k < elements.size(); ++k) {
        double square = 0;
        for (Index c = rows->start[k]; c < rows->start[k + 1]; ++c) {
          const double value =
              std::inner_product(u.begin(), u.end(), rows->rows.column(c), 0.0);
          square += value * value;
        }
        const bem::Element& element = sample.mesh[elements[k]];
        const Vec2 t = field.stress(element.curve.point(0)) * element.curve.normal(0);
        TEST_COMPARE(std::abs(square - 2 * element.half * dot(t, t)), <,
                     1e-11 * 2 * element.half);
      }
    }
  }
}

/// They would miss what the density has beyond the displacements' degree.
TEUCHOS_UNIT_TEST(ProjectedTractions, areRefusedWithFurtherDensities) {
  const bem::Mesh mesh = reference::quickSamples().front().mesh;
  std::vector<int> densities;
  for (const bem::Element& element : mesh.elements())
    densities.push_back(element.degree + 1);
  const bem::Space space(mesh.withDensities(densities));
  const bem::Lame lame({1, 0.3, false});
  for (const auto form : {bem::TractionForm::Projected, bem::TractionForm::Exact})
    TEST_THROW(bem::kernelRows(space, lame, {0, 1}, {1, 1}, form), bem::InputError);
}

TEUCHOS_UNIT_TEST(ExactTractions, containTheProjectedOnes) {
  const bem::Lame lame(bem::Material{1, 0.3, false});
  for (const auto& sample : reference::hardSamples()) {
    const bem::Space space(sample.mesh);
    const std::vector<int> elements = allElements(space.mesh());
    const bem::SteklovPoincare stiffness(bem::assembleOperators(space, lame));
    const auto rowsOf = [&](bem::TractionForm form) {
      return bem::tractionRows(space, lame, stiffness, elements, form);
    };
    const auto projected = rowsOf(bem::TractionForm::Projected);
    const auto exact = rowsOf(bem::TractionForm::Exact);
    double error = 0;
    for (std::size_t k = 0; k < elements.size(); ++k)
      for (Index c = 0; c < projected->start[k + 1] - projected->start[k]; ++c)
        for (Index i = 0; i < projected->rows.rows(); ++i)
          error = std::max(error, std::abs(projected->rows(i, projected->start[k] + c) -
                                           exact->rows(i, exact->start[k] + c)));
    out << sample.name << ": ";
    TEST_COMPARE(error, <, 1e-12 * largest(projected->rows));
  }
}

}  // namespace

}  // namespace epafi
