#pragma once

#include "Largest.hpp"
#include "bem/compressed/CompressedFactor.hpp"
#include "reference/SampleMeshes.hpp"

namespace epafi::reference {

using test::relativeDifference;

struct CompressedSample {
  std::string name;
  bem::Mesh mesh;
  double nu = 0.3;
};

/// Uniform, graded to 1e-8, rough, of high degrees, with holes and arcs; of revolution.
std::vector<CompressedSample> compressedSamples();

/// Of elasticity and of Laplace's equation.
std::vector<std::shared_ptr<const bem::Kernel>> kernelsOf(const CompressedSample& sample);

/// Leaves of 60 unknowns, so that small meshes have a tree.
bem::Compression smallLeaves();

/// The whole system by its entries.
bem::Matrix wholeSystem(const bem::Space& space, const bem::Kernel& kernel);
bem::Matrix wholeSystem(const bem::Space& space, const bem::Lame& lame);

/// Pᵀ Z P: with arcs, displacements hold the rotation exactly.
bem::Matrix rotated(bem::Matrix z, const bem::Space& space);

/// T of a cluster for all of its unknowns, which are appended to `unknowns`.
bem::Matrix nestedWeights(const bem::CompressedOperators& z, int c,
                          std::vector<bem::Index>& unknowns);

bem::Matrix oscillating(bem::Index rows, bem::Index columns);

/// Displacements of some elements are held: a clamp.  On an axis those across it always are.
bem::Restriction clamped(const bem::Space& space, int first, int last);

/// Of the kept equations, by pivoted elimination, unknowns and equations scaled by their
/// diagonal entries.
bem::Matrix denseSolution(bem::Matrix z, const bem::Restriction& restriction,
                          bem::Matrix b);

}  // namespace epafi::reference
