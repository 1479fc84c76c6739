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

#include <algorithm>
#include <ostream>
#include <utility>

namespace epafi::drivers {

namespace {

/// How much work may wait for its files [CPU seconds]: so much of a run is lost at most if it
/// is killed, and files of small levels and of steps cost as much as solving them.
constexpr double longestWait = 0.5;
/// Or so many times as much work as the files took last: those of a path grow with its steps.
constexpr double workPerWriting = 10;

/// On the level that ends a run only: many points cost more than the levels.
void writeInterior(const Scene& scene, const Level& level, OutputFolder& folder) {
  const BodyInsides insides(scene, level);
  std::vector<InsidePoint> points;
  for (const bem::Vec2 x : scene.output.interiorPoints)
    points.push_back({scene.bodyAt(scene.drawn(x)), x});
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
      steps_(earlier ? earlier->steps : ""),
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
  if (isDue())
    write();
}

bool Recorder::isDue() const {
  return cpuSeconds() - writtenAt_ > std::max(longestWait, workPerWriting * writingTook_);
}

void Recorder::stage(const LevelFiles& files) {
  folder_->stage("history.csv", history_);
  const PathRecord& path = files.path;
  for (std::size_t k = 0; k < path.contacts.size(); ++k)
    folder_->stage(stepFile(k + 1, "contact.csv"), path.contacts[k]);
  for (std::size_t k = 0; k < path.boundaries.size(); ++k)
    folder_->stage(stepFile(k + 1, "boundary.vtu"), path.boundaries[k]);
  if (!path.boundaries.empty())
    folder_->stage("steps.pvd", stepsPvd(path.times, "boundary.vtu"));
  if (scene_.hasContact())
    folder_->stage("contact.csv", files.contact);
  if (scene_.output.fields)
    folder_->stage("boundary.csv", boundaryCsv(scene_, files.grid));
  if (scene_.tellsBodies())
    folder_->stage("bodies.csv", files.bodies);
}

void Recorder::write() {
  if (!waiting_ && !waitingStep_)
    return;
  const double begin = cpuSeconds();
  if (waiting_)
    stage(*waiting_);
  if (!steps_.empty())
    folder_->stage("steps.csv", steps_);
  if (waitingStep_)
    waitingStep_->level.path = path_.points;
  const Level& level = waitingStep_ ? waitingStep_->level : *last_;
  if (scene_.output.fields)
    folder_->stage("solution.hdf",
                   waitingStep_ ? solution(level, waitingStep_->row, waitingStep_->grid)
                                : solution(level, waiting_->row, waiting_->grid));
  folder_->dropMade();
  folder_->commit();
  written_(level);
  waiting_.reset();
  waitingStep_.reset();
  writtenAt_ = cpuSeconds();
  writingTook_ = writtenAt_ - begin;
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
  steps_ += (steps_.empty() ? stepsHead(row) : "") + stepsLine(row);
  path_.contacts.push_back(contact_.next(level));
  path_.times.push_back(row.t);
  if (scene_.tellsBodies())
    bodies_ += bodiesLines(scene_, row.level, row.step, row.bodies, row.rigid);
  BoundaryLines grid;
  if (scene_.output.fields) {
    grid = boundaryLines(scene_, level);
    path_.boundaries.push_back(boundaryVtu(grid));
  }
  for (const PathPoint& point : level.path->points)
    if (path_.points.empty() || point.t > path_.points.back().t)
      path_.points.push_back(point);
  if (isKnown(level.level))
    return;
  waitingStep_ = {level.level, countedOn(level.row), std::move(grid)};
  if (isDue())
    write();
  progress_.clear();
  table_ << tableLine(row) << std::flush;
}

bool Recorder::isKnown(const Level& level) const {
  return earlier_ && level.number == earlier_->level.number &&
         path_.points.size() < earlier_->level.path.size();
}

void Recorder::writeTimings(PhaseTimer& timer) {
  if (folder_)
    folder_->write("timings.txt", timer.report() + stages_);
}

std::string Recorder::solution(const Level& level, const LevelRow& row,
                               const BoundaryLines& grid) const {
  return solutionFile(
      scene_,
      {level, used_, history_, steps_, scene_.tellsBodies() ? bodies_ : "",
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
  waiting_ = LevelFiles{bodies_, std::exchange(path_, {})};
  if (!waiting_->path.contacts.empty())
    waiting_->contact = waiting_->path.contacts.back();
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
