#include "drivers/commands/Recorder.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/BodiesTable.hpp"
#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/BoundaryVtk.hpp"
#include "drivers/output/ContactTable.hpp"
#include "drivers/output/Csv.hpp"
#include "drivers/output/HistoryTable.hpp"
#include "drivers/output/Inside.hpp"
#include "drivers/output/PrintedTable.hpp"
#include "drivers/output/SolutionFile.hpp"
#include "drivers/output/StepsTable.hpp"
#include "drivers/run/LevelWarnings.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <ostream>
#include <utility>

namespace epafi::drivers {

namespace {

/// How much work may wait for its files [CPU seconds]: so much of a run is lost at most if it
/// is killed, and files of small levels, or of a step with all before it, cost as much as
/// solving them.
constexpr double longestWait = 0.5;

/// On the level that ends a run only: many points cost more than the levels.
void writeInterior(const Scene& scene, const Level& level, OutputFolder& folder) {
  const BodyInsides insides(scene, level);
  std::vector<InsidePoint> points;
  for (const bem::Vec2 x : scene.output.interiorPoints)
    points.push_back({scene.bodyAt(x), x});
  folder.write("interior.csv", insides.csv(points, insides.at(points)));
}

}  // namespace

Recorder::Recorder(const Scene& scene, const std::optional<Checkpoint>& earlier,
                   std::optional<OutputFolder>& folder, const ProgressLine& progress,
                   std::ostream& table, std::function<void(const Level&)> written)
    : scene_(scene),
      earlier_(earlier),
      folder_(folder),
      progress_(progress),
      table_(table),
      written_(std::move(written)),
      used_(usedXml(scene)),
      history_(earlier ? earlier->history : historyHead()),
      bodies_(earlier && !earlier->bodies.empty() ? earlier->bodies : bodiesHead()),
      path_{earlier ? earlier->steps : "", {}, {}, {}},
      contact_(scene) {
  if (!folder_)
    return;
  if (earlier_)  // without rows of levels that did not make it
    folder_->write("history.csv", history_);
  folder_->write("used.xml", used_);
  folder_->drop("interior.csv");  // of an earlier level
  if (earlier_)
    last_ = earlier_->level;
}

void Recorder::take(const SolvedLevel& level) {
  ++levels_;
  if (!folder_)
    return;
  note(level);
  warnings_ = warningsOf(scene_, level);
  if (level.row.operators == denseInstead)
    told_.push_back(bem::message("level ", level.row.level, ": ", level.row.note));
  warnings_.insert(warnings_.begin(), told_.begin(), told_.end());
  if (level.path != nullptr || cpuSeconds() - writtenAt_ > longestWait)
    write();
}

void Recorder::writeStep() {
  folder_->stage("steps.csv", path_.steps);
  if (scene_.output.fields)
    folder_->stage("solution.hdf",
                   solution(waitingStep_->level, waitingStep_->row, waitingStep_->grid));
  folder_->dropMade();
  folder_->commit();
  written_(waitingStep_->level);
  waitingStep_.reset();
  writtenAt_ = cpuSeconds();
}

void Recorder::write() {
  if (waitingStep_)
    writeStep();
  if (!waiting_)
    return;
  folder_->stage("history.csv", history_);
  if (!path_.contacts.empty())
    folder_->stage("steps.csv", path_.steps);
  for (std::size_t k = 0; k < path_.contacts.size(); ++k)
    folder_->stage(stepFile(k + 1, "contact.csv"), path_.contacts[k]);
  for (std::size_t k = 0; k < path_.boundaries.size(); ++k)
    folder_->stage(stepFile(k + 1, "boundary.vtu"), path_.boundaries[k]);
  if (!path_.boundaries.empty())
    folder_->stage("steps.pvd", stepsPvd(path_.times));
  if (scene_.hasContact())
    folder_->stage("contact.csv", waiting_->contact);
  if (scene_.output.fields)
    folder_->stage("boundary.csv", boundaryCsv(scene_, waiting_->grid));
  if (scene_.hasSeveral())
    folder_->stage("bodies.csv", bodies_);
  if (scene_.output.fields)
    folder_->stage("solution.hdf", solution(*last_, waiting_->row, waiting_->grid));
  folder_->dropMade();
  folder_->commit();
  path_ = {path_.steps, {}, {}, {}};
  waiting_.reset();
  writtenAt_ = cpuSeconds();
  written_(*last_);
}

void Recorder::finish(PhaseTimer& timer) {
  if (folder_) {
    write();  // before a phase begins, which an interrupted run does not do any more
    if (last_ && !scene_.output.interiorPoints.empty())
      timer.run(Phase::Results, [&] { writeInterior(scene_, *last_, *folder_); });
  }
  writeTimings(timer);
}

void Recorder::takeStep(const SolvedLevel& level) {
  if (!folder_)
    return;
  const StepRow& row = level.path->steps.back()->row;
  path_.steps += (path_.steps.empty() ? stepsHead(row) : "") + stepsLine(row);
  path_.contacts.push_back(contact_.next(level));
  path_.times.push_back(row.t);
  if (scene_.hasSeveral())
    bodies_ += bodiesLines(scene_, row.level, row.step, row.bodies, row.rigid);
  BoundaryLines grid;
  if (scene_.output.fields) {
    grid = boundaryLines(scene_, level);
    path_.boundaries.push_back(boundaryVtu(grid));
  }
  if (isKnown(level.level))
    return;
  waitingStep_ = {level.level, countedOn(level.row), std::move(grid)};
  if (cpuSeconds() - writtenAt_ > longestWait)
    writeStep();
  progress_.clear();
  table_ << tableLine(row) << std::flush;
}

bool Recorder::isKnown(const Level& level) const {
  return earlier_ && level.number == earlier_->level.number &&
         level.path.size() < earlier_->level.path.size();
}

void Recorder::writeTimings(PhaseTimer& timer) {
  if (folder_)
    folder_->write("timings.txt", timer.report() + stages_);
}

std::string Recorder::solution(const Level& level, const LevelRow& row,
                               const BoundaryLines& grid) const {
  return solutionFile(
      scene_,
      {level, used_, history_, path_.steps, scene_.hasSeveral() ? bodies_ : "",
       row.secondsTotal, row.secondsWall},
      grid);
}

LevelRow Recorder::countedOn(LevelRow row) const {
  if (earlier_) {
    row.secondsTotal += earlier_->secondsTotal;
    row.secondsWall += earlier_->secondsWall;
  }
  return row;
}

void Recorder::note(const SolvedLevel& level) {
  const LevelRow row = countedOn(level.row);
  history_ += historyLine(row);
  stages_ += bem::message("level ", level.row.level, ": ",
                          contact::told(level.row.report.stages), "\n");
  if (level.path == nullptr)
    bodies_ += bodiesLines(scene_, level.row.level, 0, level.row.bodies, level.row.rigid);
  waitingStep_.reset();
  waiting_ = LevelFiles();
  if (!path_.contacts.empty())
    waiting_->contact = path_.contacts.back();
  else if (scene_.hasContact())
    waiting_->contact = contactCsv(scene_, level.bodies);
  if (scene_.output.fields)
    waiting_->grid = boundaryLines(scene_, level);
  waiting_->row = row;
  last_ = level.level;
  contact_ = PathContact(scene_);
  progress_.clear();
  table_ << tableLine(row) << gamma0Note(row, scene_.stabilization.firstGamma0())
         << operatorsNote(row) << worstStepNote(row) << std::flush;
}

}  // namespace epafi::drivers
