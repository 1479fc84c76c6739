#include "drivers/commands/BashCompletion.hpp"

#include <boost/algorithm/string/join.hpp>
#include <sstream>

namespace epafi::drivers {

namespace {

std::string offered(Offer offer, const std::vector<std::string>& words) {
  switch (offer) {
    case Offer::Scenes:
      return "mapfile -t COMPREPLY < <(compgen -f -X '!*.@(xml|yaml|yml)' -- \"$word\"; "
             "compgen -d -- \"$word\")";
    case Offer::Folders:
      return "mapfile -t COMPREPLY < <(compgen -d -- \"$word\")";
    case Offer::Files:
      return "mapfile -t COMPREPLY < <(compgen -f -- \"$word\")";
    case Offer::Words:
      return "mapfile -t COMPREPLY < <(compgen -W '" +
             boost::algorithm::join(words, " ") + "' -- \"$word\")";
    case Offer::Nothing:
      break;
  }
  return "COMPREPLY=()";
}

}  // namespace

std::string bashCompletion(const std::vector<Command>& commands) {
  std::ostringstream out;
  out << "# bash completion of epafi; written by `epafi help --format bash`.\n"
         "shopt -s extglob\n"
         "_epafi() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    mapfile -t COMPREPLY < <(compgen -W '";
  for (const Command& command : commands)
    out << command.name << ' ';
  out << "--help' -- \"$word\")\n    return\n  fi\n  case ${COMP_WORDS[1]} in\n";
  for (const Command& command : commands) {
    out << "    " << command.name << ")\n";
    std::string names;
    for (const Option& option : command.options) {
      names += option.name + " ";
      if (!option.value.empty())
        out << "      [[ $before == " << option.name << " ]] && { "
            << offered(option.offer, option.words) << "; return; }\n";
    }
    out << "      if [[ $word == -* ]]; then\n        mapfile -t COMPREPLY < <(compgen "
           "-W '"
        << names << "--help' -- \"$word\")\n      else\n        "
        << offered(command.argument.offer, {}) << "\n      fi\n      ;;\n";
  }
  out << "  esac\n}\ncomplete -o filenames -F _epafi epafi\n";
  return out.str();
}

}  // namespace epafi::drivers
