// One tick and one picture of a game: the page to read first.
#include "app/error_screen.h"
#include "app/game.h"

#include <utility>

namespace tumble {

void Game::tick(std::vector<InputEvent> events) {
  const double dt = tick_seconds();
  Script& script = *script_;

  // Input is sampled once a tick, and what is sampled is recorded: a game sees nothing else from outside.
  if (replay_) events = replayed_events();
  else script.run_bot(events);
  join_motion(events);
  for (const InputEvent& event : events) recorded_.emplace_back(static_cast<std::uint64_t>(ticks_), event);
  take_screen_shape(events);
  script.take_ui_input(events);
  const std::vector<InputNotice> notices = engine_->input.sample(events);

  Drawing last_drawing = std::exchange(script.tick_drawing(), {});
  script.deliver_input(notices);
  if (!script.module_settings().paused || script.steps_wanted > 0) {
    if (script.steps_wanted > 0) --script.steps_wanted;
    engine_->begin_tick();
    script.seconds_now += dt;
    script.run_tasks(dt);
    script.update(dt);
    engine_->step(dt);
    script.physics_events(engine_->take_events(), script.seconds_now - dt);
    script.animation_events(engine_->take_animation_ends());
    script.late_update(dt);
    engine_->step_particles(dt);
    standing_.reset();
  } else if (!standing_) {
    standing_ = std::move(last_drawing);
    standing_->ui.clear();
    standing_->watches.clear();
  }
  script.flush();
  script.draw_ui();
  engine_->sounds.tick(dt, script.module_settings().paused);
  script.read_report();
  script.collect_garbage();
  keep_storage();
  ++ticks_;
}

SoundList Game::heard() const {
  const ModuleSettings& settings = script_->module_settings();
  return engine_->sounds.list({settings.sound_volume, settings.sound_groups}, settings.paused);
}

DrawList Game::draw(double alpha, double dt, double aspect) {
  if (script_->loaded()) script_->frame(dt);
  DrawList list = extract(*engine_, alpha, aspect);
  list.assets = assets_.get();
  add_script_drawing(list);
  add_debug(list, alpha, aspect);
  add_log_overlay(list, aspect);
  if (script_->shown_error) add_error_screen(list, *script_->shown_error, aspect);
  return list;
}

}  // namespace tumble
