#pragma once

#include "bem/base/Keys.hpp"
#include "bem/base/Schema.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_ParameterListAcceptorDefaultBase.hpp>

#include <utility>

namespace epafi::bem {

/// The keys of options as valid parameters of Teuchos: types, units, ranges and meanings; what the
/// options hold are the defaults.
template <class Options>
Teuchos::RCP<const Teuchos::ParameterList> validParameters(Options options = {}) {
  Keys keys;
  options.keys(keys);
  const auto result = Teuchos::rcp(new Teuchos::ParameterList);
  addValidParameters(keys.rows, *result);
  return result;
}

/// What takes its Options from a list, as classes of Trilinos do; keys, checks and
/// getValidParameters() follow from Options::keys.
template <class Options>
class Acceptor : public Teuchos::ParameterListAcceptorDefaultBase {
 public:
  explicit Acceptor(Options options = {}) : options_(std::move(options)) {}

  const Options& options() const { return options_; }

  /// Reads the list.  What it does not say remains as it is, and is added to the list.
  /// \throws InputError with the path, beginning with the list's name, for an unknown key, a
  ///   wrong type or a value out of range
  void setParameterList(const Teuchos::RCP<Teuchos::ParameterList>& list) override {
    Options next = options_;
    accept(next, *list);
    options_ = std::move(next);
    setMyParamList(list);
  }
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override {
    return validParameters(options_);
  }

 private:
  Options options_;
};

}  // namespace epafi::bem
