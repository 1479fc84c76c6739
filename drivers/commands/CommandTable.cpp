#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/output/Inside.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Threads.hpp"

#include <boost/algorithm/string/join.hpp>
#include <iostream>

namespace epafi::drivers {

namespace {

using boost::algorithm::join;

/// A command that every process runs alone; only the first one prints.
template <int (*Run)(const Given&, std::ostream&)>
int alone(const Given& given, std::ostream& out, const Ranks&) {
  return Run(given, out);
}

/// A command that writes files: only the first process runs it; the others wait for its
/// end and return the same exit code.
template <int (*Run)(const Given&, std::ostream&)>
int onFirst(const Given& given, std::ostream& out, const Ranks& ranks) {
  int code = 0;
  std::exception_ptr problem;
  if (ranks.isFirst()) {
    try {
      code = Run(given, out);
    } catch (...) {
      problem = std::current_exception();
    }
  }
  code =
      static_cast<int>(ranks.processes().broadcast({static_cast<double>(code)}).front());
  if (problem)
    std::rethrow_exception(problem);
  return code;
}

std::string helpAs(const std::string& format) {
  if (format == "man")
    return madeWithProgram("man/man1/epafi.1");
  if (format == "bash")
    return madeWithProgram("bash-completion/completions/epafi");
  return format == "json" ? description(commands()) : helpOf(commands());
}

const Command& commandNamed(const std::string& name) {
  std::vector<std::string> known;
  for (const Command& command : commands()) {
    if (command.name == name)
      return command;
    known.push_back(command.name);
  }
  const bool scene =
      name.find(".xml") != std::string::npos || name.find(".yaml") != std::string::npos;
  throw bem::InputError(
      "unknown command '", name, "'",
      scene ? "; to solve a scene: epafi run " + name : bem::meant(name, known), "\n\n",
      listOf(commands()));
}

int helpCommand(const Given& given, std::ostream& out) {
  if (!given.argument.empty() && given.has("--format"))
    throw bem::InputError("help: --format is for the page of all commands; leave '",
                          given.argument, "' or it out");
  out << (given.argument.empty() ? helpAs(given.value("--format", "text"))
                                 : helpOf(commandNamed(given.argument)));
  return 0;
}

Option outputOf(const std::string& what) {
  return {"--output", "DIR",
          "the folder for the results; default: ./<" + what + " name>.out"};
}

const Option threads{
    "--threads", "N",
    "at most so many, fewer where the work is small; default: all cores, 1 under mpirun"};
const Option force{"--force", "", "replace the files of an earlier run"};
const Option quiet{"--quiet", "", "print nothing but errors"};
const Option set{"--set",
                 "'A->B->Key=value'",
                 "replace a value of the scene; a list by {Key=value, Key=value}, "
                 "nothing after the = removes a key or a list",
                 {},
                 true};

/// For how pictures look.
const std::vector<Option> looks{
    {"--size", "W,H", "of a picture in inches, exactly; default: by its content"},
    {"--dpi", "N", "pixels per inch, above 10, at most 1200; default: 110"},
    {"--font", "P", "points of the text; default: 10"},
    {"--units", "LENGTH,STRESS", "names of the scene's units for labels, as mm,MPa"},
    {"--pdf", "", "PDF beside PNG and SVG"},
    {"--no-title", "", "without titles"}};

Option format(const std::vector<std::string>& words) {
  return {"--format", join(words, "|"), "default: " + words.front(), words};
}

Option of(const std::string& standard) {
  return {"--of", "scene|study", "only these; default: " + standard, {"scene", "study"}};
}

const Option window{"--window", "X0,Y0,X1,Y1|contact",
                    "this part alone of the field, the deformed bodies and the movie; "
                    "contact: around what touches"};
const Option step{"--step", "K|all",
                  "contact, deformed and the field at this step of a load path: 1, 2, "
                  "...; default: that of the largest strain energy; all: the field "
                  "colours the movie"};

/// Of a command that draws.
std::vector<Option> withLooks(std::vector<Option> options) {
  options.insert(options.end(), looks.begin(), looks.end());
  return options;
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Command> makeCommands() {
  const Argument scene{"SCENE.xml", "scene"};
  return {
      {"run",
       "solve a scene; a table row per level, files into a folder",
       scene,
       {outputOf("scene"),
        set,
        threads,
        {"--restart", "DIR",
         "go on from the last level in DIR, in DIR itself or in --output; what the scene "
         "may change: caps, strategy, solver, output"},
        {"--reference", "FILE",
         "the solution.hdf of a finer run: history.csv gets the true errors against it"},
        {"--smallest-eigenvalue", "",
         "history.csv gets that of the stabilised stiffness relative to the plain one"},
        force,
        quiet},
       runCommand},
      {"study",
       "run variants of scenes; error against unknowns and time, one table, pictures",
       {"STUDY.xml", "study"},
       {outputOf("study"),
        threads,
        {"--force", "", "replace the files of an earlier study, references are kept"},
        {"--no-plot", "", "write the tables only; `epafi plot` draws the pictures later"},
        quiet},
       studyCommand},
      {"check",
       "read and validate only, evaluate every expression",
       scene,
       {set,
        {"--format",
         "xml|yaml|json",
         "print the scene as it is read, without defaults; check no more",
         {"xml", "yaml", "json"}},
        {"--used", "",
         "print the complete scene, as used.xml of a run or in another --format; "
         "evaluate "
         "nothing"},
        {"--numbers", "",
         "the same with the number of each expression that is the same everywhere, at "
         "the end of the path"},
        {"--plot", "FILE.png",
         "draw what was read: boundaries, conditions, loads, obstacles"}},
       onFirst<checkCommand>},
      {"parameters",
       "every parameter of scenes and studies: path, type, default, range, meaning, unit",
       {},
       {format({"text", "xml", "markdown"}), of("both, scene as xml")},
       alone<parametersCommand>},
      {"plot",
       "pictures of a finished run or study, PNG and SVG",
       {"DIR", "folder"},
       withLooks(
           {{"--field", "NAME",
             "this field inside the body, too: " + join(fieldNames(), ", "),
             fieldNames()},
            {"--picture",
             "NAME",
             "this one alone: contact, deformed, path, convergence, which are drawn "
             "if none is named, steps, slip (over place and time), rigid, mesh, "
             "contributions, time, movie, a field, one of a study; or all",
             {},
             true},
            window,
            step,
            {"--column",
             "NAME",
             "of a study's sweep: this column of study.csv against the parameter",
             {},
             true}}),
       onFirst<plotCommand>},
      {"report",
       "a run as one page of HTML: key results, pictures, scene, balance, versions",
       {"DIR", "folder"},
       withLooks({{"--output", "FILE.html", "default: report.html in DIR"},
                  {"--field", "NAME", "the field that is drawn; default: von_mises",
                   fieldNames()},
                  window,
                  step}),
       onFirst<reportCommand>},
      {"fields",
       "displacement and stress inside, after a run; csv, or all of the inside for "
       "ParaView",
       {"DIR", "folder"},
       {{"--grid", "NX,NY", "middles of so many cells of the body's box; default: 60,60"},
        {"--window", "X0,Y0,X1,Y1", "the grid over this box instead"},
        {"--points", "FILE.csv",
         "points that begin each line of a file: x,y; a row outside is empty"},
        {"--along", "BODY:BOUNDARY", "along a boundary, at the depth ..."},
        {"--depth", "D", "... below it, a length; 0: on the boundary itself"},
        {"--output", "FILE",
         "default: fields.csv or fields.vtu in DIR; -: to standard output"},
        {"--vtk", "",
         "triangles of the whole inside for ParaView, small at small elements"},
        {"--step", "K|all",
         "at this step of a load path: 1, 2, ...; default: the last; all: rows of all "
         "steps, with --vtk fields.pvd, a series for ParaView"},
        threads},
       onFirst<fieldsCommand>},
      {"schema",
       "the schema of scenes and studies for editors: RELAX NG for XML, JSON Schema for "
       "YAML",
       {},
       {format({"rng", "json"}), of("both")},
       alone<schemaCommand>},
      {"version", "what this program is made of", {}, {}, alone<versionCommand>},
      {"help",
       "this page, or the options of one command; as man page or completion of bash; "
       "json: "
       "all commands and parameters",
       {"COMMAND", "command", false},
       {format({"text", "man", "bash", "json"})},
       alone<helpCommand>},
  };
}

/// The command for the usual options --help, -h and --version.
std::string synonym(const std::string& name) {
  if (name == "--help" || name == "-h")
    return "help";
  return name == "--version" ? "version" : name;
}

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> table = makeCommands();
  return table;
}

int dispatch(const std::vector<std::string>& arguments, const Ranks& ranks) {
  if (arguments.empty())
    throw bem::InputError("no command is given\n\n" + helpOf(commands()));
  const Command& command = commandNamed(synonym(arguments.front()));
  const Given given = parseArguments(command, {arguments.begin() + 1, arguments.end()});
  std::ostream silence(nullptr);
  std::ostream& out = ranks.isFirst() ? std::cout : silence;
  if (given.has("--help")) {
    out << helpOf(command);
    return 0;
  }
  chooseThreads(threadsOf(given), ranks);
  return command.run(given, out, ranks);
}

}  // namespace epafi::drivers
