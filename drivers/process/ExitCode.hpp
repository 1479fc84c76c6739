#pragma once

namespace epafi::drivers {

/// Exit codes of the program, and their meanings in `epafi --help`.
enum ExitCode {
  Solved = 0,
  BadInput = 1,
  Breakdown = 2,
  NotConverged = 3,
  Signalled = 128
};

struct ExitMeaning {
  ExitCode code;
  const char* more;  ///< text behind the number of the code
  const char* meaning;
};

inline constexpr ExitMeaning exitCodes[] = {
    {Solved, "", "solved; also when a cap on levels or unknowns ends the run"},
    {BadInput, "", "bad input or usage, a file that is missing or cannot be written"},
    {Breakdown, "", "the arithmetic broke down, or forces do not balance"},
    {NotConverged, "", "not converged: the state is written, the status says so"},
    {Signalled, " + signal", "interrupted; the levels that were solved are written"}};

}  // namespace epafi::drivers
