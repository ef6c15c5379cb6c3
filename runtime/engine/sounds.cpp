#include "engine/sounds.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "engine/engine.h"
#include "engine/extract.h"

namespace tumble {

namespace {

constexpr std::size_t kTogether = 2;    // sounds of one file that begin in one tick; more would only be louder
constexpr std::size_t kOfOneFile = 8;   // and that are heard at once
constexpr std::size_t kMostLoops = 200;
constexpr double kKept = 1;             // s that a stopped one stays listed, so that the mixer hears of it

std::string music_group() { return "music"; }

void end(PlayingSound& sound, double fade) {
  if (sound.stopped()) return;
  sound.stopped_for = 0;
  sound.fade_out = fade;
}

}  // namespace

void describe(SoundOptions& options, Schema& s) {
  s.name("sound.play", "What sound.play takes beside the file.");
  s.add("volume", options.volume, "1 is as recorded.").between(0, 4);
  s.add("pitch", options.pitch, "2 is an octave higher and half as long.").between(0.1, 10);
  s.add("range", options.range, "From so far away it cannot be heard, m; up to an eighth of it, it is heard in full.").above(0).allow_infinite();
  s.add("loop", options.loop, "Does it begin again at its end?");
  s.add("group", options.group, "Whose volume it goes by: sound.groups.");
}

void describe(MusicOptions& options, Schema& s) {
  s.name("sound.music", "What sound.music takes beside the file.");
  s.add("volume", options.volume, "1 is as recorded.").between(0, 4);
  s.add("fade", options.fade, "How long it takes to come, and the one before it to go, s.").between(0, 60);
}

std::vector<std::string> Sounds::groups() const {
  std::vector<std::string> names{"effects", music_group()};
  for (const std::string& name : engine_.settings.sound.groups)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

void Sounds::check_group(const std::string& group, const std::string& call) const {
  const std::vector<std::string> names = groups();
  if (std::find(names.begin(), names.end(), group) != names.end()) return;
  const std::string near = did_you_mean(group, names);
  fail(call, ": no group '", group, "'", near.empty() ? "; name it in game.json: \"sound\": { \"groups\": [\"" + group + "\"] }" : near);
}

void Sounds::check(const Sound& sound) const {
  check_group(sound.group, "sound.group");
  if (engine_.assets && !sound.file.empty()) engine_.assets->sound(sound.file);
}

// ---- beginning and ending

std::uint64_t Sounds::play(const std::string& file, const SoundOptions& options, NodeId node, std::optional<Vec3> place, const std::string& call) {
  check_group(options.group, call);
  const auto loops = static_cast<std::size_t>(std::count_if(playing_.begin(), playing_.end(), [](const PlayingSound& s) { return s.options.loop && !s.stopped(); }));
  if (options.loop && loops >= kMostLoops)
    fail(call, ": ", loops, " sounds with loop = true are playing; start a loop once, and stop() it when it is no longer needed");
  PlayingSound& sound = begin(file, options);
  sound.node = node;
  sound.place = place;
  move(sound);
  return sound.id;
}

PlayingSound& Sounds::begin(const std::string& file, const SoundOptions& options) {
  PlayingSound& sound = playing_.emplace_back();
  sound.id = next_id_++;
  sound.file = file;
  sound.options = options;
  take_file(sound);
  return sound;
}

void Sounds::take_file(PlayingSound& sound) const {
  if (!engine_.assets || sound.file.empty()) return;
  sound.pcm = engine_.assets->sound(sound.file);
  sound.version = engine_.assets->version(sound.file);
}

void Sounds::stop(std::uint64_t id, double fade) {
  if (PlayingSound* sound = find(id)) end(*sound, fade);
}

PlayingSound* Sounds::find(std::uint64_t id) {
  const auto found = std::lower_bound(playing_.begin(), playing_.end(), id, [](const PlayingSound& s, std::uint64_t wanted) { return s.id < wanted; });
  return found != playing_.end() && found->id == id && !found->stopped() ? &*found : nullptr;
}

void Sounds::music(const std::string& file, const MusicOptions& options) {
  PlayingSound* now = find(music_);
  if (now && now->file == file) {
    now->options.volume = options.volume;
    return;
  }
  if (now) end(*now, options.fade);
  music_ = 0;
  if (file.empty()) return;
  SoundOptions loop;
  loop.volume = options.volume;
  loop.loop = true;
  loop.group = music_group();
  PlayingSound& sound = begin(file, loop);
  sound.fade_in = options.fade;
  music_ = sound.id;
}

void Sounds::play_node(NodeId node) {
  engine_.scene[node].sound->playing = true;
  watched_[node].again = true;
}

void Sounds::scene_restarted() {
  for (auto& [node, watched] : watched_) watched.again = true;
}

// ---- a tick

void Sounds::tick(double seconds, bool paused) {
  for (auto at = watched_.begin(); at != watched_.end();) at = follow(at->first, at->second) ? std::next(at) : watched_.erase(at);
  thin_out();
  for (PlayingSound& sound : playing_) {
    move(sound);
    if (sound.fresh && paused) sound.through_pause = true;
    if (sound.stopped()) sound.stopped_for += seconds;
    else if (!sound.fresh && !sound.held && !(paused && !sound.through_pause)) sound.time += seconds * sound.options.pitch;
    sound.fresh = false;
    if (engine_.assets && sound.version != engine_.assets->version(sound.file)) take_file(sound);  // it was saved
  }
  for (const PlayingSound& sound : playing_)
    if (sound.of_node && sound.node && !sound.stopped() && sound.ended()) engine_.scene[sound.node].sound->playing = false;
  std::erase_if(playing_, [](const PlayingSound& sound) {
    return sound.stopped() ? sound.stopped_for > sound.fade_out + kKept : sound.ended();
  });
}

// What a node's component says, done. False where there is none any more.
bool Sounds::follow(NodeId node, Watched& watched) {
  SceneNode* content = engine_.scene.get(node);
  PlayingSound* playing = find(watched.sound);
  if (!content || !content->sound) {
    if (playing) end(*playing, 0);
    return false;
  }
  Sound& sound = *content->sound;
  if (playing && (watched.again || !sound.playing || playing->file != sound.file)) {
    end(*playing, 0);
    playing = nullptr;
  }
  watched.again = false;
  if (!playing && sound.playing) {
    playing = &begin(sound.file, {});
    playing->node = node;
    playing->of_node = true;
  }
  watched.sound = playing ? playing->id : 0;
  if (!playing) return true;
  playing->options = {sound.volume, sound.pitch, sound.range, sound.loop, sound.group};
  playing->held = !engine_.scene.enabled_in_tree(node);
  return true;
}

// Where its node is. One whose node has gone stays where that was; a loop would go on for ever and ends.
void Sounds::move(PlayingSound& sound) {
  if (!sound.node) return;
  if (engine_.scene.get(sound.node)) {
    sound.place = engine_.scene.world(sound.node).position;
    return;
  }
  sound.node = {};
  if (sound.options.loop) end(sound, 0);
}

// A hundred equal knocks at once are not a louder world but a broken one: of each file the loudest are heard.
void Sounds::thin_out() {
  if (std::none_of(playing_.begin(), playing_.end(), [](const PlayingSound& s) { return s.fresh; })) return;
  const Vec3 ear = camera_view(engine_).pose.position;
  struct Entry {
    PlayingSound* sound;
    double loudness;
  };
  std::map<std::string, std::vector<Entry>> by_file;
  for (PlayingSound& sound : playing_) {
    if (!sound.pcm || sound.options.loop || sound.stopped() || sound.unheard) continue;
    const double nearness = sound.place ? loudness_at(length(*sound.place - ear), sound.options.range) : 1;
    by_file[sound.file].push_back({&sound, sound.options.volume * nearness * (1 - sound.time / sound.length())});
  }
  for (auto& [file, entries] : by_file) {
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.loudness > b.loudness; });
    std::size_t all = 0, fresh = 0;
    for (const Entry& entry : entries) {
      const bool heard = all < kOfOneFile && !(entry.sound->fresh && fresh >= kTogether);
      entry.sound->unheard = !heard;
      all += heard;
      fresh += heard && entry.sound->fresh;
    }
  }
}

// ---- what is heard

SoundList Sounds::list(const SoundVolumes& volumes, bool paused) const {
  SoundList list;
  list.volume = volumes.all;
  for (const PlayingSound& sound : playing_)
    if (sound.pcm) list.sounds.push_back(heard(sound, volumes, paused));
  const bool placed = std::any_of(list.sounds.begin(), list.sounds.end(), [](const HeardSound& s) { return s.place.has_value(); });
  if (!placed) return list;
  const Pose ear = camera_view(engine_).pose;
  for (HeardSound& sound : list.sounds)
    if (sound.place) sound.place = conjugate(ear.rotation) * (*sound.place - ear.position);
  return list;
}

HeardSound Sounds::heard(const PlayingSound& sound, const SoundVolumes& volumes, bool paused) const {
  HeardSound heard;
  heard.id = sound.id;
  heard.pcm = sound.pcm;
  const auto group = volumes.groups.find(sound.options.group);
  heard.volume = sound.options.volume * (group == volumes.groups.end() ? 1 : group->second);
  heard.pitch = sound.options.pitch;
  heard.loop = sound.options.loop;
  heard.held = sound.held || (paused && !sound.through_pause && !sound.fresh);
  heard.stopped = sound.stopped() || sound.unheard;
  heard.fade = sound.stopped() ? sound.fade_out : sound.time < sound.fade_in ? sound.fade_in : 0;
  heard.time = sound.time;
  heard.place = sound.place;
  heard.range = sound.options.range;
  return heard;
}

}  // namespace tumble
