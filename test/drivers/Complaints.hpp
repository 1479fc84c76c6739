#pragma once

#include "test/drivers/SceneText.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cctype>

// Every kind of bad input ends with an InputError that names the file, the path A->B->Key
// and what is allowed; complaintOf() checks the file, the tests the path and the names and
// numbers, in whatever sentence.

namespace epafi::test {

/// A path ends where no letter follows: 'Degree' is not at 'Degre'.
inline bool isAt(const std::string& complaint, const std::string& place) {
  const std::size_t at = complaint.find(place);
  const std::size_t end = at + place.size();
  return at != std::string::npos && !complaint.empty() &&
         (end == complaint.size() ||
          std::isalnum(static_cast<unsigned char>(complaint[end])) == 0);
}

/// Does the complaint about a scene name the place, a path behind what is common to all,
/// and the words?
#define TEST_COMPLAINT(text, place, ...)                                  \
  {                                                                       \
    const std::string complaint = complaintOf(text);                      \
    out << complaint << "\n";                                             \
    TEST_ASSERT(::epafi::test::isAt(complaint, place));                   \
    for (const std::string& word : std::vector<std::string>{__VA_ARGS__}) \
      TEST_ASSERT(::epafi::test::contains(complaint, word));              \
  }

inline SceneText withDiscretization(const std::string& content) {
  SceneText scene;
  scene.discretization += content;
  return scene;
}

inline SceneText withVertices(const std::string& table, const std::string& edges) {
  SceneText scene;
  scene.geometry = outline(table, edges);
  return scene;
}

}  // namespace epafi::test
