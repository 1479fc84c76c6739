#include "bem/fields/NearElements.hpp"

#include "bem/kernel/ElementSums.hpp"
#include "bem/moments/LegendreLanes.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

EPAFI_INLINE void addProduct(const Complex& factor, const Pack& real, const Pack& imag,
                             AlignedLane* sums) {
  add(sums[0].lane, factor.real() * real - factor.imag() * imag);
  add(sums[1].lane, factor.real() * imag + factor.imag() * real);
}

/// ∫ P_j ds/conj(w) = τ C_j,  ∫ P_j w/conj(w)² ds = τ³ (C_j - 2ib D_j) of a segment,
/// (1 - z²) D_j = (j+1) (C_{j+1} - z C_j).  Parts 1: on its own line, b = 0.
template <int Parts>
struct FieldKernel {
  const Sight& sight;
  const std::vector<EndPoint>& points;
  const LocalField* fields;
  std::size_t states;
  int terms;
  Complex tangent;
  NearElements::Lanes* sums;

  template <Division How>
  EPAFI_INLINE void run() const {
    const Complex cube = tangent * tangent * tangent;
    LegendreLanes<Parts> legendre;
    NearElements::Lanes* to = sums;
    for (std::size_t first = 0; first < points.size(); first += lanes) {
      const PointLanes at(points, first);
      const TargetLanes x(sight, at);
      legendre.evaluate(x, Parts == 1 ? terms - 1 : terms);
      for (std::size_t k = 0; k < 2 * states; ++k) {
        const LocalField& field = fields[k / 2];
        const auto& g = k % 2 == 0 ? field.density : field.slope;
        AlignedLane* sum = to[k / 2].sum[k % 2];
        Pack real{};  // Σ g_j Re C_j
        Pack imag{};
        for (int j = 0; j < terms; ++j) {
          real += g[j].real() * legendre.c[0][j];
          imag += g[j].imag() * legendre.c[0][j];
        }
        if constexpr (Parts == 1) {
          addProduct(std::conj(tangent), real, imag, sum);
          addProduct(tangent, real, imag, sum + 2);
          addProduct(cube, real, -imag, sum + 4);
        } else {
          Pack turnedReal{};  // Σ g_j Im C_j
          Pack turnedImag{};
          Pack slopeReal{};  // Σ conj(g_j) (j+1) (C_{j+1} - z C_j)
          Pack slopeImag{};
          for (int j = 0; j < terms; ++j) {
            const Pack& cr = legendre.c[0][j];
            const Pack& ci = legendre.c[1][j];
            turnedReal += g[j].real() * ci;
            turnedImag += g[j].imag() * ci;
            const Pack dr = (j + 1.0) * (legendre.c[0][j + 1] - x.z * cr + x.b * ci);
            const Pack di = (j + 1.0) * (legendre.c[1][j + 1] - x.z * ci - x.b * cr);
            slopeReal += g[j].real() * dr + g[j].imag() * di;
            slopeImag += g[j].real() * di - g[j].imag() * dr;
          }
          addProduct(std::conj(tangent), real + turnedImag, imag - turnedReal, sum);
          addProduct(tangent, real - turnedImag, imag + turnedReal, sum + 2);
          // 2ib / (z² - 1)
          const Pack productReal = x.minus * x.plus - x.b * x.b;
          const Pack productImag = x.b * (x.minus + x.plus);
          const Pack scale =
              2.0 * x.b / (productReal * productReal + productImag * productImag);
          const Pack factorReal = scale * productImag;
          const Pack factorImag = scale * productReal;
          addProduct(cube,
                     real + turnedImag + factorReal * slopeReal - factorImag * slopeImag,
                     turnedReal - imag + factorReal * slopeImag + factorImag * slopeReal,
                     sum + 4);
        }
      }
      to += states;
    }
  }
};

}  // namespace

NearElements::NearElements(const Mesh& mesh, int element,
                           const std::vector<EndPoint>& points, std::size_t states)
    : mesh_(mesh),
      element_(element),
      points_(points),
      states_(states),
      ofSegments_((points.size() + lanes - 1) / lanes * states),
      ofArcs_(points.size() * states) {}

void NearElements::add(int source, const LocalField* fields, InstructionSet set) {
  const Element& y = mesh_[source];
  const int terms = std::max(y.degree, y.densities);
  if (y.curve.isStraight() && mesh_[element_].curve.isStraight()) {
    const Sight sight = sightOf(mesh_, element_, source);
    const Complex tangent = asComplex(y.curve.segment().tangent);
    if (mesh_[element_].piece.edge == y.piece.edge)
      dispatch(set, FieldKernel<1>{sight, points_, fields, states_, terms, tangent,
                                   ofSegments_.data()});
    else
      dispatch(set, FieldKernel<2>{sight, points_, fields, states_, terms, tangent,
                                   ofSegments_.data()});
    return;
  }
  ElementSums sums;
  for (std::size_t q = 0; q < points_.size(); ++q) {
    const BoundaryPoint x = mesh_.at(element_, points_[q].fromStart, points_[q].toEnd);
    sums.evaluate(y.curve, seenFrom(mesh_, source, x), terms);
    for (std::size_t k = 0; k < states_; ++k)
      for (int j = 0; j < terms; ++j)
        ofArcs_[q * states_ + k].add(
            {fields[k].density[j] * sums[j], fields[k].slope[j] * sums[j]});
  }
}

FieldSums NearElements::at(std::size_t point, std::size_t state) const {
  const Lanes& eight = ofSegments_[point / lanes * states_ + state];
  const auto sums = [&](const AlignedLane* of) {
    const auto number = [&](int k) {
      return Complex(of[k].lane[point % lanes], of[k + 1].lane[point % lanes]);
    };
    return SourceSums{number(0), number(2), number(4)};
  };
  FieldSums result{sums(eight.sum[0]), sums(eight.sum[1])};
  result.add(ofArcs_[point * states_ + state]);
  return result;
}

}  // namespace epafi::bem
