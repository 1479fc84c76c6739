#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/Space.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

class FarBlocks;
class PairColumns;

/// A family of kernels: all that the assembly, the energy norm and the compressed system know of
/// it.  Its functions are those of a Space with as many components.
///
/// A new family derives from this class and hands out
///
///   pairs()  PairColumns: entries near and far, by integration by parts.  From TileBlocks if its
///            kernels are sums of the moments of Tile, else a class of its own (RingBlocks)
///   far()    FarBlocks: entries far from each other without cancellation and fields on proxy
///            circles, by point kernels.  From FarQuadrature, which takes the kernels
///
/// and makes them known by one function below; everything else takes them through here.
class Kernel {
 public:
  Kernel() = default;
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;
  virtual ~Kernel() = default;

  virtual int components() const = 0;
  /// A stress over a strain, or a flux over a gradient, of the body: densities and displacements
  /// are comparable by it.  Young's modulus over the reference stress.
  virtual double stiffness() const = 0;

  /// Refer to the space; one object per thread.
  virtual std::unique_ptr<PairColumns> pairs(const Space& space) const = 0;
  virtual std::unique_ptr<FarBlocks> far(const Space& space) const = 0;

  /// As many displacements of the outer surface as there are rigid motions (of a scalar field: the
  /// constant), which hold these.
  virtual std::vector<Index> resting(const Space& space) const = 0;
};

/// Of linear elasticity: of plane bodies or solids of revolution, as the outline says.
std::shared_ptr<const Kernel> elasticKernel(const Outline& outline, const Lame& lame);

/// Of Laplace's equation in the plane: displacements are values of the function, densities
/// its fluxes.
std::shared_ptr<const Kernel> laplaceKernel();

}  // namespace epafi::bem
