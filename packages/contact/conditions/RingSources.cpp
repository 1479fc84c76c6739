#include "contact/conditions/RingSources.hpp"

#include "bem/base/Matrix.hpp"
#include "bem/moments/RingFunctions.hpp"
#include "bem/simd/Dispatch.hpp"

#include <cmath>

namespace epafi::contact {

using bem::Pack;
using bem::RingJet;
using bem::Vec2;

/// Adds what eight rings have at x.
struct RingSources::Sum {
  const Eight& from;
  Vec2 x;
  Value& to;

  template <bem::Division How>
  EPAFI_INLINE void run() const {
    constexpr double turns = 0.012665147955292222;  // 1/8π²
    constexpr double close = 1e-5;                  // to the axis
    const Pack zero{};
    const Pack& a = bem::load(from.radius.lane);
    const Pack strength = turns * bem::load(from.strength.lane);
    const Pack& dipole = bem::load(from.dipole.lane);
    const RingJet rho{zero + x.x, zero + 1.0, zero};
    const RingJet dr{x.x - a, zero + 1.0, zero};
    const RingJet dz{x.y - bem::load(from.height.lane), zero, zero + 1.0};
    bem::RingFunctionsOf<RingJet> ring;
    bem::ringFunctions<How>(dr * dr + dz * dz, 4.0 * (a * rho), ring);
    const RingJet& e0 = ring.e0;
    const RingJet& e1 = ring.e1;
    // derivatives of both with respect to a
    const RingJet c0 = dr * (ring.g1 + ring.g2) - 2.0 * (rho * ring.g2);
    const RingJet c1 = dr * (ring.g1 - ring.g2) - 2.0 * (rho * (ring.g2 - 2.0 * ring.g3));
    const RingJet square = rho * rho + dz * dz + RingJet{a * a, zero, zero};
    const RingJet temperature = strength * e0 - dipole * c0;
    const Pack half = 0.5 * strength;
    const Pack part = 0.5 * dipole;
    const RingJet potential =
        half * (square * e0 - (2.0 * a) * (rho * e1)) - part * (a * e0 - rho * e1);
    const RingJet r = half * (rho * e0 - a * e1) - part * (rho * c0 - e1 - a * c1);
    const RingJet z = half * (dz * e0) - part * (dz * c0);
    const double t = sumOf(temperature.value);
    const double across = sumOf(r.r);
    to.temperature += t;
    to.slope = to.slope + Vec2{sumOf(temperature.r), sumOf(temperature.z)};
    to.potential += sumOf(potential.value);
    to.gradient = to.gradient + Vec2{sumOf(r.value), sumOf(z.value)};
    to.stress = to.stress + BodyStress{across - t, sumOf(z.z) - t, sumOf(r.z),
                                       (x.x > close ? sumOf(r.value) / x.x : across) - t};
  }

 private:
  EPAFI_INLINE static double sumOf(const Pack& p) {
    return ((p[0] + p[1]) + (p[2] + p[3])) + ((p[4] + p[5]) + (p[6] + p[7]));
  }
};

void RingSources::add(const Source& source) {
  const auto lane = static_cast<int>(count_++ % bem::lanes);
  if (lane == 0) {
    Eight& eight = rings_.emplace_back();
    for (int k = 0; k < bem::lanes; ++k) {
      eight.radius.lane[k] = source.place.x;
      eight.height.lane[k] = source.place.y;
    }
  }
  Eight& eight = rings_.back();
  eight.radius.lane[lane] = source.place.x;
  eight.height.lane[lane] = source.place.y;
  eight.strength.lane[lane] = source.strength;
  eight.dipole.lane[lane] = source.dipole;
}

RingSources::Value RingSources::at(Vec2 x) const {
  Value value;
  for (const Eight& eight : rings_)
    bem::dispatch(Sum{eight, x, value});
  if (line_ != 0) {
    const double log = std::log(x.x);
    const double t = line_ * log;
    value.temperature += t;
    value.slope.x += line_ / x.x;
    value.potential += 0.25 * line_ * x.x * x.x * (log - 1);
    value.gradient.x += 0.25 * line_ * x.x * (2 * log - 1);
    value.stress = value.stress + BodyStress{0.25 * line_ * (2 * log + 1) - t, -t, 0,
                                             0.25 * line_ * (2 * log - 1) - t};
  }
  return value;
}

}  // namespace epafi::contact
