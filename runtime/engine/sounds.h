// What is to be heard of a game: sounds that scripts play, sounds of nodes, and the music.
//
// All of it is in game time: what is playing follows from ticks and from the lengths of files, so it is the same with and
// without loudspeakers, and nothing that is heard comes back into the game. list() says what is to be heard now.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/describe.h"
#include "base/pcm.h"
#include "platform/mixer.h"
#include "scene/node.h"

namespace tumble {

class Engine;

// What sound.play takes beside the file and the place.
struct SoundOptions {
  double volume = 1, pitch = 1;
  double range = 30;                // m
  bool loop = false;
  std::string group = "effects";
};
void describe(SoundOptions& options, Schema& s);

struct MusicOptions {
  double volume = 1;
  double fade = 1;                  // s
};
void describe(MusicOptions& options, Schema& s);

// How loud everything is, and each group.
struct SoundVolumes {
  double all = 1;
  std::map<std::string, double> groups;
};

struct PlayingSound {
  std::uint64_t id = 0;
  std::string file;
  std::shared_ptr<const Pcm> pcm;   // null: the file cannot be played, and its length is 0
  std::uint64_t version = 0;        // of the file
  SoundOptions options;
  NodeId node;                      // that it moves with
  std::optional<Vec3> place;        // where it is, or its node was last; none: everywhere
  double time = 0;                  // s of the file that have passed
  double fade_in = 0, fade_out = 0; // s
  bool fresh = true;                // begun in this tick
  bool of_node = false;             // a node's component, rather than played by a script
  bool held = false;                // its node is not enabled
  bool through_pause = false;       // begun while the game was paused
  bool unheard = false;             // one too many of its file
  double stopped_for = -1;          // s; below 0: it goes on

  bool stopped() const { return stopped_for >= 0; }
  double length() const { return pcm ? pcm->seconds() : 0; }
  bool ended() const { return !options.loop && time >= length(); }
};

class Sounds {
 public:
  explicit Sounds(Engine& engine) : engine_(engine) {}

  // "effects", "music" and what game.json adds.
  std::vector<std::string> groups() const;
  // Throws Error beginning with `call` for a group that is none.
  void check_group(const std::string& group, const std::string& call) const;
  // The same for a component, whose file is read at once: what is missing is said early, and nothing waits when it plays.
  void check(const Sound& sound) const;

  // Plays a file once, or again and again. `node`, if any, is followed. The number names it for good.
  std::uint64_t play(const std::string& file, const SoundOptions& options, NodeId node, std::optional<Vec3> place, const std::string& call);
  void stop(std::uint64_t id, double fade);
  // nullptr where it has ended or was stopped.
  PlayingSound* find(std::uint64_t id);
  // One music plays at a time; another one fades in while it fades out. "" is silence, the same file goes on.
  void music(const std::string& file, const MusicOptions& options);

  // A node has a sound component, new or changed.
  void watch(NodeId node) { watched_.try_emplace(node); }
  void play_node(NodeId node);      // from the beginning
  void scene_restarted();           // sounds of nodes begin anew

  // The end of a tick, also of one in which the game is paused.
  void tick(double seconds, bool paused);
  SoundList list(const SoundVolumes& volumes, bool paused) const;

 private:
  struct Watched {
    std::uint64_t sound = 0;        // what plays; 0: nothing
    bool again = false;
  };
  PlayingSound& begin(const std::string& file, const SoundOptions& options);
  bool follow(NodeId node, Watched& watched);
  void thin_out();
  void move(PlayingSound& sound);
  void take_file(PlayingSound& sound) const;
  HeardSound heard(const PlayingSound& sound, const SoundVolumes& volumes, bool paused) const;

  Engine& engine_;
  std::vector<PlayingSound> playing_;  // by age, and so by number
  std::map<NodeId, Watched> watched_;
  std::uint64_t next_id_ = 1, music_ = 0;
};

}  // namespace tumble
