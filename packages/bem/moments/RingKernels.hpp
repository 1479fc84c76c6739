#pragma once

#include "bem/base/Material.hpp"
#include "bem/moments/RingFunctions.hpp"
#include "bem/simd/ComplexPack.hpp"

namespace epafi::bem {

/// Places on two rings: their radii, x - y and the unit tangents there.
struct RingPair {
  Pack x;  ///< radius of x
  Pack y;
  ComplexPack w;
  ComplexPack tangentX;
  ComplexPack tangentY;
};

/// Constants of the kernels of solids of revolution: V = A (E₁, E₀) + B P, and those of K and W
/// without a difference of large numbers as ν -> 1/2.           [doc/theory/axisymmetric.md]
struct RingLame {
  double a;     ///< A = (3-4ν)/(16πμ(1-ν))
  double b;     ///< B = 1/(16πμ(1-ν))
  double part;  ///< 1 - 2ν
  double doubled;  ///< 2μB:  2μV - L = 2μB ((1-2ν)(E₁, E₀) + P),  L = (E₁, E₀)/4π
  double squared;  ///< 4μ²B: 2μL - 4μ²V = -4μ²B ((1-2ν)(E₁, E₀) + P)
  double curl;     ///< μ/2π

  explicit RingLame(const Lame& lame)
      : a(0.5 * lame.a),
        b(0.5 * lame.b),
        part(1 - 2 * lame.nu),
        doubled(2 * lame.mu * b),
        squared(2 * lame.mu * doubled),
        curl(lame.mu / 6.2831853071795865) {}
};

/// The kernels of V, K and W between two points, times the radii of the functions that have one:
/// densities ψ and derivatives u' are integrated as rψ and ru', displacements u_r as they are.
///
/// Kernels with both radii, of densities and derivatives; P the part of V that depends on
/// direction:
///
///   e1, e0  r_x r_y (E₁, E₀);  es  r_x r_y E_s;  rr, zr, rz, zz  r_x r_y P, its first index at x.
///
/// Where a displacement u_r of x or y appears:
///
///   ofX[0..2]   K from x to y:  u_r -> ψ_r, u_r -> ψ_z, u_z -> ψ_z, the last two of K_L
///   ofY[0..2]   the same from y to x
///   xSlope[2]   W: u_r(x) with u_r'(y), u_z'(y)
///   ySlope[2]   W: u_r'(x), u_z'(x) with u_r(y)
///   both        W: u_r(x) with u_r(y)
struct RingKernels {
  static constexpr int count = 18;
  enum Kernel {
    e1,
    e0,
    es,
    rr,
    zr,
    rz,
    zz,
    ofX,
    ofY = ofX + 3,
    xSlope = ofY + 3,
    ySlope = xSlope + 2,
    both = ySlope + 2
  };
  Pack of[count];
};

template <Division How>
EPAFI_INLINE void ringKernels(const RingLame& lame, const RingPair& at, RingKernels& to) {
  RingFunctions ring;
  const Pack& rx = at.x;
  const Pack& ry = at.y;
  const Pack& dr = at.w.re;
  const Pack& dz = at.w.im;
  const Pack product = rx * ry;
  ringFunctions<How>(dr * dr + dz * dz, 4.0 * product, ring);
  const Pack sum = ring.g1 + ring.g2;
  const Pack difference = ring.g1 - ring.g2;
  const Pack drSum = dr * sum;
  const Pack rr = dr * dr * difference - 4.0 * product * ring.g3;
  const Pack rz = dz * (drSum + 2.0 * ry * ring.g2);
  const Pack zr = dz * (drSum - 2.0 * rx * ring.g2);
  const Pack zz = dz * dz * sum;
  to.of[RingKernels::e1] = product * ring.e1;
  to.of[RingKernels::e0] = product * ring.e0;
  to.of[RingKernels::es] = product * ring.es;
  to.of[RingKernels::rr] = product * rr;
  to.of[RingKernels::rz] = product * rz;
  to.of[RingKernels::zr] = product * zr;
  to.of[RingKernels::zz] = product * zz;

  // X/(-4μ²B) = Y/(2μB), first index at x
  const Pack xrr = lame.part * ring.e1 + rr;
  const Pack xzz = lame.part * ring.e0 + zz;
  const Pack& txr = at.tangentX.re;
  const Pack& txz = at.tangentX.im;
  const Pack& tyr = at.tangentY.re;
  const Pack& tyz = at.tangentY.im;
  // n = (t_z, -t_r)
  const Pack nxr = txz * xrr - txr * zr;  // n(x)·X, columns r and z
  const Pack nxz = txz * rz - txr * xzz;
  const Pack nyr = tyz * xrr - tyr * rz;  // X·n(y), rows r and z
  const Pack nyz = tyz * zr - tyr * xzz;

  constexpr double laplace = 0.079577471545947668;  // 1/4π
  const Pack flowX = -(txz * dr - txr * dz);        // of the normal derivative at x
  const Pack flowY = tyz * dr - tyr * dz;
  const Pack turned = 2.0 * (ring.g2 - 2.0 * ring.g3);
  const Pack whole = 2.0 * ring.g2;
  to.of[RingKernels::ofX] =
      ry * (laplace * rx * (flowX * difference - ry * txz * turned) - lame.doubled * nxr);
  to.of[RingKernels::ofX + 1] = -lame.doubled * ry * nxz;
  to.of[RingKernels::ofX + 2] = laplace * product * (flowX * sum - ry * txz * whole);
  to.of[RingKernels::ofY] =
      rx * (laplace * ry * (flowY * difference - rx * tyz * turned) - lame.doubled * nyr);
  to.of[RingKernels::ofY + 1] = -lame.doubled * rx * nyz;
  to.of[RingKernels::ofY + 2] = laplace * product * (flowY * sum - rx * tyz * whole);

  to.of[RingKernels::xSlope] = ry * (lame.squared * nxz + lame.curl * ring.es * txr);
  to.of[RingKernels::xSlope + 1] = -lame.squared * ry * nxr;
  to.of[RingKernels::ySlope] = rx * (lame.squared * nyz + lame.curl * ring.es * tyr);
  to.of[RingKernels::ySlope + 1] = -lame.squared * rx * nyr;
  to.of[RingKernels::both] =
      lame.curl * (txr * tyr * (ring.e0 - ring.es) + txz * tyz * ring.e1) -
      lame.squared * (nxr * tyz - nxz * tyr);
}

}  // namespace epafi::bem
