#include "contact/results/Balance.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

namespace {

using bem::Vec2;

constexpr double smallest = 1e-14;  // what rounding takes of a product
constexpr double farAway = 1e-6;    // moments of a body there lose digits

bool isIncompressible(double compressibility) { return !(compressibility > 1e-12); }

/// Of F.  Pressures in an incompressible body that is thin lose more digits.
double ofForces(double compressibility) {
  return isIncompressible(compressibility) ? 1e-3 : 1e-9;
}

/// Of μ |u|.
double ofMotions(double compressibility, bool isFormed) {
  constexpr double least = 1e-7;
  return (isFormed ? smallest : 5e-12) * (1 + 0.2 / std::max(compressibility, least));
}

/// The same of work, μ |u|²: without compression V is regular, and so is what it solves for.
double ofWork(double compressibility, bool isFormed) {
  return ofMotions(isFormed && isIncompressible(compressibility) ? 1 : compressibility,
                   isFormed);
}

/// A force that free motions may miss, dimensionless.
double unsolvedForce(const ContactSystem& system, double tolerance) {
  const Vector lengths = system.multiplier().lengths();
  return 2 * tolerance * system.numbers().stress *
         std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

double forceOf(const Resultant& r) { return std::hypot(r.x, r.y); }

void add(const Resultant& more, Resultant& sum) {
  sum.x += more.x;
  sum.y += more.y;
  sum.moment += more.moment;
}

/// Of a body's own multiplier [stress length].
struct ContactForces {
  double all = 0;    ///< ∫ |λ|
  Vec2 ofObstacles;  ///< on the body, where no other body is in contact
};

ContactForces contactForces(const Solved& solved) {
  ContactForces forces;
  const ContactFields fields(solved);
  const bem::Mesh& mesh = solved.space.mesh();
  for (const auto& element : fields.elements()) {
    const bem::Curve& side = mesh[element.element].curve;
    forEachPointOf(
        element, solved.problem.multiplier().basis(),
        bem::gaussLegendre(element.degree + std::max(2, side.pointsOfTurning())),
        [&](const SidePoint& point) {
          const auto stress = fields.stress(element, point.t);
          const double area = solved.units.measure() * point.weight;
          forces.all += area * std::hypot(stress.normal, stress.tangential);
          Vec2 force = area * (stress.normal * point.normal.unit +
                               stress.tangential * point.tangent.unit);
          if (solved.units.isAxisymmetric)  // around the axis they cancel
            force.x = 0;
          if (element.condition->name.empty() && !element.condition->isSupport)
            forces.ofObstacles = forces.ofObstacles - force;
        });
  }
  return forces;
}

/// The force of a spring by its length, and what rounding leaves of that: where there is none, what
/// holds the component.
std::pair<double, double> heldBy(const Drive::Component& drive, double motion,
                                 double reaction) {
  if (drive.stiffness == 0)
    return {reaction, 0};
  return {drive.stiffness * (drive.end - motion),
          smallest * drive.stiffness * (std::abs(drive.end) + std::abs(motion))};
}

/// Without what the forces of all say of it.  Where forces cancel they are as large as what moves the
/// body by |u| at its strain energy; of a body without strain all is rounding, as large as `rounding`.
Imbalance ofElastic(const Solved& solved, const Summary& summary, double around,
                    double rounding) {
  constexpr double strained =
      1e-24;  // a beam of 1 : 10000 has 1e-13, rounding squared 1e-32
  Imbalance imbalance;
  const double energy = summary.energyStrain;
  const double motion = solved.units.length * bem::largestEntry(solved.displacement);
  imbalance.largest =
      motion > 0 && energy > strained * rounding * solved.units.length * around
          ? 2 * energy / motion
          : rounding;
  for (const auto member :
       {&Summary::load, &Summary::inside, &Summary::contact, &Summary::reaction}) {
    add(summary.*member, imbalance.missing);
    imbalance.largest = std::max(imbalance.largest, forceOf(summary.*member));
  }
  const bem::Outline& outline = solved.space.mesh().outline();
  const Vec2 middle = outline.physical({0, 0});
  imbalance.missing.moment -= cross(middle, {imbalance.missing.x, imbalance.missing.y});
  imbalance.size = std::max(
      forceOf(imbalance.missing),
      std::abs(imbalance.missing.moment) / (outline.diameter() + farAway * norm(middle)));
  return imbalance;
}

/// \param reach  moments count over this, dimensionless
Imbalance ofRigid(const Drive& drive, const RigidMotion& motion, double reach,
                  const std::array<double, 3>& contact, const bem::Units& units) {
  const double force = units.force();
  const double motions[] = {motion.slide.x, motion.slide.y, motion.turn};
  Imbalance imbalance;
  double missing[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const Drive::Component& one = drive.components[c];
    const double acts = contact[c] + one.inside + (one.free ? one.value : 0);
    const auto [held, rounding] = heldBy(one, motions[c], one.free ? 0 : -acts);
    missing[c] = force * (acts + held);
    const double unit = force / (c < 2 ? 1 : reach);
    imbalance.rounding = std::max(imbalance.rounding, unit * rounding);
    for (const double x : {contact[c], one.inside, held})
      imbalance.largest = std::max(imbalance.largest, unit * std::abs(x));
  }
  imbalance.missing = {missing[0], missing[1], units.length * missing[2]};
  imbalance.size = std::max(forceOf(imbalance.missing), std::abs(missing[2]) / reach);
  return imbalance;
}

}  // namespace

std::vector<Imbalance> Balance::of(const ContactSystem& system, const Configuration& at,
                                   const std::vector<Solved>& bodies,
                                   const std::vector<Summary>& summaries,
                                   double tolerance) {
  const bem::Units units = bodies.front().units;
  const double force = units.force();
  const double unsolved = force * unsolvedForce(system, tolerance);
  const bool isFormed = system.body(0).elastic()->isFormed();
  double ofAll = 0;
  std::vector<Imbalance> all;
  Imbalance contact;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    // with that of body loads, which alone is there where a body grows freely
    motions_[b] = std::max({motions_[b], bem::largestEntry(at.displacements[b]),
                            system.body(b).loads().inside.largestDeformation});
    const double modulus =
        bodies[b].motions != nullptr ? bodies[b].motions->shearModuli[b] : 1;
    const double size = force * modulus * motions_[b];
    ofAll = std::max(ofAll, size);
    Imbalance& own =
        all.emplace_back(ofElastic(bodies[b], summaries[b], motions_[b], size));
    own.rounding = ofMotions(compressibilities_[b], isFormed) * size;
    own.unsolved = system.body(b).holding().free() == 0 ? 0 : unsolved;
    const ContactForces pressed = contactForces(bodies[b]);
    contact.largest = std::max(contact.largest, pressed.all);
    contact.missing.x += summaries[b].contact.x - pressed.ofObstacles.x;
    contact.missing.y += summaries[b].contact.y - pressed.ofObstacles.y;
  }
  const auto forces = system.rigidForces(at.state);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const Drive& drive = system.drives()[k];
    Imbalance& own = all.emplace_back(
        ofRigid(drive, at.rigid[k], std::max(1.0, system.lever(k)), forces[k], units));
    own.rounding += smallest * ofAll;
    own.unsolved = drive.isFree() ? unsolved : 0;
    contact.missing.x += force * forces[k][0];
    contact.missing.y += force * forces[k][1];
  }
  contact.size = forceOf(contact.missing);
  contact.rounding = smallest * ofAll;
  all.push_back(contact);
  largest_.resize(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k + 1 < all.size())
      all[k].body = k;
    largest_[k] = std::max({largest_[k], all[k].largest, contact.largest});
    all[k].largest = largest_[k];
    all[k].rounding +=
        ofForces(k < bodies.size() ? compressibilities_[k] : 1) * largest_[k];
  }
  return all;
}

VirtualWork Balance::workOf(const ContactSystem& system, const Configuration& at,
                            const Vector& shearModuli, double tolerance) {
  VirtualWork work = virtualWork(system, at);
  largestWork_ = std::max(largestWork_, work.size);
  work.rounding += ofForces(1) * largestWork_;
  const bool isFormed = system.body(0).elastic()->isFormed();
  double moved = 0;  // of what moves freely
  for (std::size_t b = 0; b < motions_.size(); ++b) {
    work.rounding += ofWork(compressibilities_[b], isFormed) * shearModuli[b] *
                     motions_[b] * motions_[b];
    // without compression a pressure does no work, but by rounding
    if (isIncompressible(compressibilities_[b]))
      work.rounding += ofWork(1, isFormed) / shearModuli[b] *
                       std::pow(system.body(b).loads().largestTraction, 2);
    moved += system.body(b).holding().free() == 0 ? 0 : motions_[b];
  }
  for (std::size_t k = 0; k < at.rigid.size(); ++k)
    if (system.drives()[k].isFree())
      moved += norm(at.rigid[k].slide) + system.lever(k) * std::abs(at.rigid[k].turn);
  work.unsolved += moved * unsolvedForce(system, tolerance);
  return work;
}

}  // namespace epafi::contact
