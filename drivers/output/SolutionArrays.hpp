#pragma once

#include "drivers/run/Level.hpp"

#include <array>
#include <tuple>
#include <vector>

namespace epafi::drivers {

/// A level's numbers as they stand in solution.hdf: those of the bodies one body after the
/// other, those of a path one step after the other, in a step again the bodies.
struct SolutionArrays {
  std::vector<int> edge;
  std::vector<int> degree;
  std::vector<double> position;  ///< fromStart, toEnd of the start and of the end
  std::vector<double> indicators;
  std::vector<double> multiplier;
  std::vector<double> rigid;
  std::vector<int> contact;
  std::vector<int> friction;
  std::vector<double> displacement;
  std::vector<double> density;

  std::vector<int>
      bodies;  ///< how many entries of the above each body has, see BodyCount
  std::vector<double> rigidBodies;  ///< motions

  std::vector<double> pathTimes;
  std::vector<int> pathIterations;  ///< Newton's and Coulomb's
  std::vector<double> pathMultiplier;
  std::vector<double> pathRigid;
  std::vector<double> pathErrors;  ///< see PathPoint::workError

  /// Of the steps that were asked for; a path on its way has none.
  std::vector<double> stepTimes;
  std::vector<double> stepDisplacement;
  std::vector<double> stepDensity;
  std::vector<int> stepContact;
  std::vector<int> stepFriction;
  std::vector<double> stepRigidBodies;  ///< motions
};

/// What a body has of something.
enum BodyCount {
  Elements,
  Normals,
  Tangentials,
  Motions,
  Displacements,
  Densities,
  BodyCounts
};

/// One of the arrays, its rows of a body: the counts from `first` to `last` together.
template <class Number>
struct DataSet {
  const char* name = nullptr;
  std::vector<Number> SolutionArrays::*array = nullptr;
  int columns = 1;
  BodyCount first = Elements;
  BodyCount last = first;
};

// In the order of the checksum.
constexpr std::tuple bodyDataSets(
    DataSet<int>{"edge", &SolutionArrays::edge},
    DataSet<int>{"degree", &SolutionArrays::degree},
    DataSet<double>{"position", &SolutionArrays::position, 4},
    DataSet<double>{"indicators", &SolutionArrays::indicators, adaptivity::sourceCount},
    DataSet<double>{"multiplier", &SolutionArrays::multiplier, 1, Normals, Tangentials},
    DataSet<double>{"rigid", &SolutionArrays::rigid, 1, Motions},
    DataSet<int>{"contact_state", &SolutionArrays::contact, 1, Normals},
    DataSet<int>{"friction_state", &SolutionArrays::friction, 1, Tangentials},
    DataSet<double>{"displacement", &SolutionArrays::displacement, 1, Displacements},
    DataSet<double>{"density", &SolutionArrays::density, 1, Densities});
constexpr std::tuple otherDataSets(
    DataSet<int>{"bodies", &SolutionArrays::bodies, BodyCounts},
    DataSet<double>{"rigid_bodies", &SolutionArrays::rigidBodies, 3},
    DataSet<double>{"path_t", &SolutionArrays::pathTimes},
    DataSet<int>{"path_iterations", &SolutionArrays::pathIterations, 2},
    DataSet<double>{"path_multiplier", &SolutionArrays::pathMultiplier},
    DataSet<double>{"path_rigid", &SolutionArrays::pathRigid},
    DataSet<double>{"path_work_error", &SolutionArrays::pathErrors},
    DataSet<double>{"step_t", &SolutionArrays::stepTimes},
    DataSet<double>{"step_displacement", &SolutionArrays::stepDisplacement},
    DataSet<double>{"step_density", &SolutionArrays::stepDensity},
    DataSet<int>{"step_contact_state", &SolutionArrays::stepContact},
    DataSet<int>{"step_friction_state", &SolutionArrays::stepFriction},
    DataSet<double>{"step_rigid_bodies", &SolutionArrays::stepRigidBodies, 3});

/// visit(data set) of each.
template <class Visit>
void forEachDataSet(const Visit& visit) {
  const auto each = [&](const auto&... set) { (visit(set), ...); };
  std::apply(each, bodyDataSets);
  std::apply(each, otherDataSets);
}

SolutionArrays arraysOf(const Level& level);

/// And back, what arrays say of a level.
/// \throws bem::InputError if they do not go together, or hold a state that there is not.
Level levelOf(const SolutionArrays& arrays);

}  // namespace epafi::drivers
