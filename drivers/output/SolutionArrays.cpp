#include "drivers/output/SolutionArrays.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <string_view>

namespace epafi::drivers {

namespace {

constexpr const char* apart = "/Epafi: bodies does not go with the other arrays";

std::size_t sizeOf(const SolutionArray& array) {
  return std::visit([](const auto& numbers) { return numbers.size(); }, array.numbers);
}

/// Copies the values that it visits from a level to arrays, or back.
class Archive {
 public:
  enum class To { Arrays, Level };
  Archive(SolutionArrays& arrays, To to) : arrays_(arrays), to_(to) {
    for (const SolutionArray& array : arrays)
      most_ += sizeOf(array);
  }

  void operator()(const char* name, int& value) { take(name, &value, 1); }
  void operator()(const char* name, double& value) { take(name, &value, 1); }
  void operator()(const char* name, bem::Vector& values) {
    take(name, values.data(), values.size());
  }
  void operator()(const char* name, std::vector<contact::RigidMotion>& motions) {
    for (auto& [slide, turn] : motions)
      for (double* number : {&slide.x, &slide.y, &turn})
        (*this)(name, *number);
  }
  template <class State>
  void operator()(const char* name, std::vector<State>& states, State last) {
    for (State& state : states) {
      auto number = static_cast<int>(state);
      (*this)(name, number);
      if (number < 0 || number > static_cast<int>(last))
        throw bem::InputError("/Epafi: ", number, " is no state");
      state = static_cast<State>(number);
    }
  }

  /// Writes the sizes of vectors, or resizes the vectors to the stored sizes.
  template <class... T>
  void sizes(const char* name, std::vector<T>&... all) {
    const auto size = [&](auto& vector) {
      auto number = static_cast<int>(vector.size());
      (*this)(name, number);
      resize(vector, static_cast<std::size_t>(number));
    };
    (size(all), ...);
  }
  /// Resizes a vector of a level that is read; does nothing when writing.
  template <class T>
  void resize(std::vector<T>& vector, std::size_t size) const {
    if (to_ == To::Arrays)
      return;
    if (size > most_)
      throw bem::InputError(apart);
    vector.resize(size);
  }
  /// Rows of an array, divided by `parts`.
  std::size_t rows(const char* name, std::size_t parts = 1) {
    const SolutionArray& array = named(name);
    return sizeOf(array) / array.columns / parts;
  }

 private:
  SolutionArray& named(std::string_view name) {
    return *std::find_if(arrays_.begin(), arrays_.end(),
                         [&](const SolutionArray& array) { return array.name == name; });
  }

  template <class T>
  void take(const char* name, T* first, std::size_t count) {
    SolutionArray& array = named(name);
    auto& numbers = std::get<std::vector<T>>(array.numbers);
    if (to_ == To::Arrays) {
      numbers.insert(numbers.end(), first, first + count);
      return;
    }
    if (count > numbers.size() - array.taken)
      throw bem::InputError(apart);
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(array.taken), count, first);
    array.taken += count;
  }

  SolutionArrays& arrays_;
  To to_;
  std::size_t most_ = 0;  ///< all numbers; no size in a file may be larger
};

void visit(Archive& archive, BodyLevel& body) {
  auto& [normal, tangential] = body.states;
  archive.sizes("bodies", body.pieces, normal, tangential, body.state.rigid,
                body.displacement, body.density);
  archive.resize(body.indicators.squares, body.pieces.size());
  archive.resize(body.state.multiplier, normal.size() + tangential.size());
  for (bem::Piece& piece : body.pieces) {
    archive("edge", piece.edge);
    archive("degree", piece.degree);
    for (bem::Position* end : {&piece.start, &piece.end})
      for (double* distance : {&end->fromStart, &end->toEnd})
        archive("position", *distance);
  }
  for (adaptivity::Contributions& squares : body.indicators.squares)
    for (double& square : squares)
      archive("indicators", square);
  archive("multiplier", body.state.multiplier);
  archive("rigid", body.state.rigid);
  archive("contact_state", normal, contact::NormalState::Closed);
  archive("friction_state", tangential, contact::FrictionState::SlipBackward);
  archive("displacement", body.displacement);
  archive("density", body.density);
}

void visit(Archive& archive, PathPoint& point, std::size_t points) {
  archive.resize(point.state.multiplier, archive.rows("path_multiplier", points));
  archive.resize(point.state.rigid, archive.rows("path_rigid", points));
  archive("path_t", point.t);
  archive("path_iterations", point.newtonIterations);
  archive("path_iterations", point.coulombIterations);
  archive("path_multiplier", point.state.multiplier);
  archive("path_rigid", point.state.rigid);
  archive("path_work_error", point.workError);
}

void visit(Archive& archive, StepFields& step, const Level& level) {
  archive("step_t", step.t);
  archive.resize(step.displacement, level.bodies.size());
  archive.resize(step.density, level.bodies.size());
  archive.resize(step.states, level.bodies.size());
  archive.resize(step.rigid, level.rigid.size());
  for (std::size_t b = 0; b < level.bodies.size(); ++b) {
    const BodyLevel& body = level.bodies[b];
    auto& [normal, tangential] = step.states[b];
    archive.resize(step.displacement[b], body.displacement.size());
    archive.resize(step.density[b], body.density.size());
    archive.resize(normal, body.states.normal.size());
    archive.resize(tangential, body.states.tangential.size());
    archive("step_displacement", step.displacement[b]);
    archive("step_density", step.density[b]);
    archive("step_contact_state", normal, contact::NormalState::Closed);
    archive("step_friction_state", tangential, contact::FrictionState::SlipBackward);
  }
  archive("step_rigid_bodies", step.rigid);
}

void visit(Archive& archive, Level& level) {
  archive.resize(level.bodies, archive.rows("bodies"));
  for (BodyLevel& body : level.bodies)
    visit(archive, body);
  archive.resize(level.rigid, archive.rows("rigid_bodies"));
  archive("rigid_bodies", level.rigid);
  archive.resize(level.path, archive.rows("path_t"));
  for (PathPoint& point : level.path)
    visit(archive, point, level.path.size());
  archive.resize(level.steps, archive.rows("step_t"));
  for (StepFields& step : level.steps)
    visit(archive, step, level);
}

}  // namespace

SolutionArrays emptyArrays() {
  const std::vector<double> real;
  const std::vector<int> whole;
  return {{"edge", 1, whole},
          {"degree", 1, whole},
          {"position", 4, real},
          {"indicators", adaptivity::sourceCount, real},
          {"multiplier", 1, real},
          {"rigid", 1, real},
          {"contact_state", 1, whole},
          {"friction_state", 1, whole},
          {"displacement", 1, real},
          {"density", 1, real},
          {"bodies", 6, whole},
          {"rigid_bodies", 3, real},
          {"path_t", 1, real},
          {"path_iterations", 2, whole},
          {"path_multiplier", 1, real},
          {"path_rigid", 1, real},
          {"path_work_error", 1, real},
          {"step_t", 1, real},
          {"step_displacement", 1, real},
          {"step_density", 1, real},
          {"step_contact_state", 1, whole},
          {"step_friction_state", 1, whole},
          {"step_rigid_bodies", 3, real}};
}

SolutionArrays arraysOf(Level level) {
  SolutionArrays arrays = emptyArrays();
  Archive archive(arrays, Archive::To::Arrays);
  visit(archive, level);
  return arrays;
}

Level levelOf(SolutionArrays arrays) {
  Level level;
  Archive archive(arrays, Archive::To::Level);
  visit(archive, level);
  for (const SolutionArray& array : arrays)
    if (array.taken != sizeOf(array))
      throw bem::InputError(apart);
  return level;
}

}  // namespace epafi::drivers
