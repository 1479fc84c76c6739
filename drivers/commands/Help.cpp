#include "drivers/commands/Help.hpp"

#include "drivers/process/ExitCode.hpp"

#include <boost/algorithm/string/join.hpp>
#include <sstream>

namespace epafi::drivers {

namespace {

const char* const title = "frictional contact of linear elastic bodies in the plane";

std::string nameOf(const ExitMeaning& exit) {
  return std::to_string(exit.code) + exit.more;
}

std::string leftOf(const Option& option) {
  return option.name + (option.value.empty() ? "" : " " + option.value);
}

std::string meaningOf(const Option& option) {
  return option.meaning + (option.repeatable ? "; repeatable" : "");
}

/// `text` in lines of at most `width`, all but the first indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::istringstream words(text);
  std::string result;
  std::size_t column = indent;
  for (std::string word; words >> word;) {
    if (column > indent && column + 1 + word.size() > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result;
}

/// "  left        what it means"
std::string line(const std::string& left, const std::string& meaning,
                 std::size_t indent) {
  constexpr std::size_t column = 34;
  constexpr std::size_t width = 98;
  std::string text = std::string(indent, ' ') + left;
  text += text.size() + 2 > column ? "\n" + std::string(column, ' ')
                                   : std::string(column - text.size(), ' ');
  return text + wrapped(meaning, column, width) + "\n";
}

std::string optionLines(const Command& command, std::size_t indent) {
  std::string text;
  for (const Option& option : command.options)
    text += line(leftOf(option), meaningOf(option), indent);
  return text;
}

/// For roff: a hyphen is a minus sign, a line does not begin with a control character.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '-' || c == '\\')
      result += '\\';
    if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
      result += "\\&";
    result += c;
  }
  return result;
}

}  // namespace

std::string usageLine(const Command& command) {
  const std::string& name = command.argument.name;
  std::string text = "epafi " + command.name;
  if (!name.empty())
    text += command.argument.required ? " " + name : " [" + name + "]";
  if (command.options.size() > 2)
    return text + " [options]";
  for (const Option& option : command.options)
    text += " [" + leftOf(option) + "]" + (option.repeatable ? "..." : "");
  return text;
}

std::string helpOf(const Command& command) {
  std::string text =
      "usage: " + usageLine(command) + "\n\n" + wrapped(command.purpose, 0, 98) + "\n";
  if (!command.options.empty())
    text += "\n" + optionLines(command, 2);
  return text;
}

std::string helpOf(const std::vector<Command>& commands) {
  std::string text = "Epafi: " + std::string(title) + "\n\n";
  for (const Command& command : commands)
    text += line(usageLine(command), command.purpose, 2) + optionLines(command, 6);
  text += line("epafi COMMAND --help", "the same of one command", 2) + "\nExit codes\n";
  for (const ExitMeaning& exit : exitCodes)
    text += line(nameOf(exit), exit.meaning, 2);
  return text;
}

std::string listOf(const std::vector<Command>& commands) {
  std::string text;
  for (const Command& command : commands)
    text += line(command.name, command.purpose, 2);
  return text;
}

std::string manPage(const std::vector<Command>& commands) {
  std::ostringstream out;
  out << ".TH EPAFI 1\n.SH NAME\nepafi \\- " << title << "\n.SH SYNOPSIS\n";
  for (const Command& command : commands)
    out << ".B " << roff(usageLine(command)) << "\n.br\n";
  out << ".SH COMMANDS\n";
  for (const Command& command : commands) {
    out << ".SS " << roff(usageLine(command)) << "\n" << roff(command.purpose) << ".\n";
    for (const Option& option : command.options)
      out << ".TP\n.B " << roff(leftOf(option)) << "\n"
          << roff(meaningOf(option)) << "\n";
  }
  out << ".SH EXIT STATUS\n";
  for (const ExitMeaning& exit : exitCodes)
    out << ".TP\n.B " << nameOf(exit) << "\n" << roff(exit.meaning) << "\n";
  out << ".SH FILES\nA run writes a folder, ./<scene>.out unless \\-\\-output says "
         "otherwise:\nhistory.csv, contact.csv, boundary.csv, interior.csv, "
         "solution.hdf, used.xml,\ntimings.txt; a study study.csv.\n";
  return out.str();
}

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
