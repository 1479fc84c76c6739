#pragma once

#include "bem/base/Error.hpp"

#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace epafi::bem {

/// Registry of named objects: friction laws, bases, strategies.  Built-in members come first,
/// then those that a program adds before it reads its first scene.
///
/// A member has a `name`; references to members stay valid.
template <class Member>
class Family {
 public:
  /// \param kind name of a member in messages, such as "friction law"
  Family(std::string kind, std::vector<Member> members) : kind_(std::move(kind)) {
    for (Member& member : members)
      add(std::move(member));
  }

  /// \throws InputError if there is a member of this name.
  void add(Member member) {
    if (find(member.name) != nullptr)
      throw InputError(kind_, " '", member.name, "' exists already");
    members_.push_back(std::move(member));
  }

  /// \throws InputError naming the known members.
  const Member& at(const std::string& name) const {
    const Member* member = find(name);
    if (member != nullptr)
      return *member;
    std::string known;
    for (const Member& other : members_)
      known += (known.empty() ? "'" : ", '") + std::string(other.name) + "'";
    throw InputError(kind_, " '", name, "'; known: ", known);
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const Member& member : members_)
      result.push_back(member.name);
    return result;
  }

  auto begin() const { return members_.begin(); }
  auto end() const { return members_.end(); }
  const Member& front() const { return members_.front(); }

 private:
  const Member* find(const std::string& name) const {
    for (const Member& member : members_)
      if (member.name == name)
        return &member;
    return nullptr;
  }

  std::string kind_;
  std::deque<Member> members_;
};

/// "A: meaning of A; B: meaning of B"; members have a `meaning`.
template <class Member>
std::string meanings(const Family<Member>& family) {
  std::string text;
  for (const Member& member : family)
    text += (text.empty() ? "" : "; ") + std::string(member.name) + ": " + member.meaning;
  return text;
}

}  // namespace epafi::bem
