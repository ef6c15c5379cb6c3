// A game that starts anew, and one that opens another in its folder and comes back after it.
#include "app/runtime_impl.h"

#include <utility>

namespace tumble {

// At the end of a tick: what the game asked the program for.
void Runtime::Impl::serve_requests() {
  const GameRequests wanted = game->script().requests;
  if (wanted.restart) return restart();
  if (!wanted.open.empty()) return open_other(wanted.open);
  if (wanted.quit) go_home();
}

void Runtime::Impl::restart() { reopen(path, game->script().storage.now(), "restarted"); }

void Runtime::Impl::open_other(const std::string& other) {
  game->script().requests.open.clear();
  const auto folder = game->package().folder();
  if (!folder) return game->say("game.open: only a game in a folder can open others; this one is packed in a file");
  const std::string from = home.empty() ? path : home;
  if (!reopen((*folder / other).string(), {}, "opened '" + other + "'")) return;
  home = from;
  game->say("F1: back to where you came from");
}

void Runtime::Impl::go_home() {
  if (!home.empty() && reopen(home, {}, "back again")) home.clear();
}

// A game.json that became faulty meanwhile must not end the game that runs.
bool Runtime::Impl::reopen(const std::string& wanted, const Stored& kept, const std::string& note) {
  const std::string before = std::exchange(path, wanted);
  if (before != wanted) next_recording.reset();   // it is of the other game
  try {
    open_game(kept);
    if (host.on_log) host.on_log(LogLevel::note, note);
    return true;
  } catch (const Error& error) {
    path = before;
    game->script().requests.restart = false;
    game->script().shown_error = ScriptFailure{error.what(), "", "", 0, "", true};
    if (host.on_log) host.on_log(LogLevel::error, error.what());
    return false;
  }
}

}  // namespace tumble
