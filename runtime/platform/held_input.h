// What is held down just now: turns a device's reports into a tidy order of events, each press with its release.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "platform/input.h"

namespace tumble {

class HeldInput {
 public:
  // A press of what is held already, or a release of what is not, says nothing.
  void press(const std::string& name, std::vector<InputEvent>& out);
  void release(const std::string& name, std::vector<InputEvent>& out);
  // A stick's or trigger's new value, 0..1.
  void set_value(const std::string& name, double value, std::vector<InputEvent>& out);
  // When the window loses focus, releases would go unheard: this tells them all, in alphabetical order.
  void release_all(std::vector<InputEvent>& out);

 private:
  std::set<std::string> held_;
  std::map<std::string, double> values_;
};

}  // namespace tumble
