// Sounds: the module, what it gives, and the component of nodes.
#include <algorithm>

#include "base/text.h"
#include "script/areas.h"
#include "script/script.h"
#include "script/view.h"

namespace tumble {

namespace {

constexpr double kLoudest = 4;
constexpr double kFaintest = 0.02;  // of a hit; what is softer is not heard beside what goes on

double checked_volume(double volume, const std::string& name) {
  if (volume < 0 || volume > kLoudest) fail(name, ": 0 to 4 expected, got ", number_text(volume), "; 1 is as recorded");
  return volume;
}

// Where a sound comes from.
struct Place {
  NodeId node;
  std::optional<Vec3> point;
};

// Takes `at` out of the options: the rest is described.
Place take_place(Script& s, Value& options, const std::string& call) {
  Map* map = options.get<Map>();
  if (!map) return {};
  const auto found = std::find_if(map->begin(), map->end(), [](const auto& entry) { return entry.first == "at"; });
  if (found == map->end()) return {};
  const Value at = std::move(found->second);
  map->erase(found);
  if (const Vec3* point = at.get<Vec3>()) return {{}, *point};
  const Reference* reference = at.get<Reference>();
  if (!reference || reference->kind != Reference::Kind::node) fail(call, ": at: vec3 or node expected, got ", kind_name(at));
  const NodeId node{reference->index, reference->generation};
  if (!s.engine().scene.get(node)) fail(call, ": at: ", s.dead_node_text(node));
  return {node, {}};
}

VoiceRef voice_of(VoiceData& data, std::uint64_t id, const SoundOptions& options) {
  data = {id, options.volume, options.pitch};
  return {&data};
}

// ---- the module

Results play(Script& s, std::string file, std::optional<Value> given) {
  Value rest = given.value_or(Value{});
  const Place place = take_place(s, rest, "sound.play");
  SoundOptions options;
  if (!rest.is_nil()) assign(options, rest, "sound.play");
  VoiceData data;
  const VoiceRef voice = voice_of(data, s.engine().sounds.play(file, options, place.node, place.point, "sound.play"), options);
  return {LuaType<VoiceRef>::push(s.stack(), voice)};
}

void hit(Script& s, std::string file, HitRef hit, double full, std::optional<Value> given) {
  if (full <= 0) fail("sound.hit: full must be above 0 (got ", number_text(full), "); give the impulse in N s that is heard at full volume");
  SoundOptions options;
  if (given) assign(options, *given, "sound.hit");
  const double strength = std::min(hit.hit->impulse / full, 1.0);
  if (strength < kFaintest) return;
  options.volume *= strength;
  s.engine().sounds.play(file, options, {}, hit.hit->point, "sound.hit");
}

void music(Script& s, std::optional<std::string> file, std::optional<Value> given) {
  MusicOptions options;
  if (given) assign(options, *given, "sound.music");
  s.engine().sounds.music(file.value_or(""), options);
}

double volume(Script& s) { return s.settings().sound_volume; }
void set_volume(Script& s, double volume) { s.settings().sound_volume = checked_volume(volume, "sound.volume"); }
Results groups(Script& s) {
  push_object(s.stack(), Tag::sound_groups, NodeId{});
  return {1};
}

// ---- sound.groups.music

double& group_at(Script& s, lua_State* L) {
  if (lua_type(L, 2) != LUA_TSTRING) fail("sound.groups: the name of a group expected, got ", describe_argument(L, 2));
  const std::string name = lua_tostring(L, 2);
  s.engine().sounds.check_group(name, "sound.groups");
  return s.settings().sound_groups[name];
}

int groups_index(lua_State* L) {
  return at_border(L, [L] { return lua_pushnumber(L, group_at(script_of(L), L)), 1; });
}

int groups_newindex(lua_State* L) {
  return at_border(L, [L] {
    Script& s = script_of(L);
    double& group = group_at(s, L);
    static const Row row = [] {
      Row r;
      r.area = "sound";
      r.name = "groups";
      r.kind = Row::Kind::property;
      r.permit = Permit::write;
      return r;
    }();
    check_permit(s, row);
    const std::string name = std::string("sound.groups.") + lua_tostring(L, 2);
    if (lua_type(L, 3) != LUA_TNUMBER) fail(name, ": number expected, got ", describe_argument(L, 3));
    group = checked_volume(lua_tonumber(L, 3), name);
    return 0;
  });
}

// ---- what sound.play gives

void stop(Script& s, VoiceRef v, std::optional<double> fade) {
  if (fade.value_or(0) < 0) fail("voice:stop: fade must not be below 0 (got ", number_text(*fade), "); give seconds");
  s.engine().sounds.stop(v.voice->id, fade.value_or(0));
}
bool is_playing(Script& s, VoiceRef v) { return s.live_engine().sounds.find(v.voice->id) != nullptr; }
double voice_volume(Script&, VoiceRef v) { return v.voice->volume; }
double voice_pitch(Script&, VoiceRef v) { return v.voice->pitch; }

// One that has ended takes what is written and stays silent.
void set_voice_volume(Script& s, VoiceRef v, double volume) {
  v.voice->volume = checked_volume(volume, "voice.volume");
  if (PlayingSound* sound = s.engine().sounds.find(v.voice->id)) sound->options.volume = volume;
}
void set_voice_pitch(Script& s, VoiceRef v, double pitch) {
  if (pitch < 0.1 || pitch > 10) fail("voice.pitch: 0.1 to 10 expected, got ", number_text(pitch), "; 2 is an octave higher");
  v.voice->pitch = pitch;
  if (PlayingSound* sound = s.engine().sounds.find(v.voice->id)) sound->options.pitch = pitch;
}

// ---- the component

Sound& sound_of(Script& s, ComponentRef c, const char* call) {
  SceneNode& node = s.engine().scene[c.node];
  if (!node.sound) fail(call, ": node '", node.name, "' has no sound any more");
  return *node.sound;
}
void play_component(Script& s, ComponentRef c) {
  sound_of(s, c, "sound:play");
  s.engine().sounds.play_node(c.node);
}
void stop_component(Script& s, ComponentRef c) { sound_of(s, c, "sound:stop").playing = false; }

}  // namespace

void rows_sound_module(Area& a) {
  a.fn<play>("play", "Plays a WAV or OGG file once, or with loop until it is stopped. Options: at (a vec3, or a node that it moves with; nil: "
                     "everywhere), volume (0 to 4; 1 is as recorded), pitch (0.1 to 10; 2 is an octave higher), range (30 m, from there on it is silent; "
                     "up to an eighth of it, it is heard in full), loop, group (\"effects\"). A paused game holds it, unless it began while paused.",
             "file", "options").acts().takes(1, "table").gives("voice");
  a.fn<hit>("hit", "Plays a file where two bodies met, as loud as they met: in full at an impulse of `full` N s or more, in proportion below. "
                   "For on_collision_enter. Options as for play, without at.", "file", "hit", "full", "options").acts().takes(3, "table");
  a.fn<music>("music", "Plays a file again and again, in the group \"music\". One music plays at a time: another fades in while it fades out, the same goes "
                       "on, nil is silence. It goes on when a scene is loaded. Options: volume, fade (1 s).", "file", "options").acts().takes(1, "table");
  a.prop<volume, set_volume>("volume", "How loud everything is: 0 is silence, 1 as recorded, 4 the most.");
  a.prop<groups>("groups", "How loud each group of sounds is, 0 to 4: sound.groups.music = 0.5. There are \"effects\", \"music\" and what game.json adds "
                           "under sound.groups.").gives("table");
}

void rows_voice(Area& a) {
  a.method<stop>("stop", "Ends it, over so many seconds (0).", "fade").acts();
  a.prop<voice_volume, set_voice_volume>("volume", "1 is as recorded; 0 to 4.");
  a.prop<voice_pitch, set_voice_pitch>("pitch", "2 is an octave higher and half as long; 0.1 to 10.");
  a.prop<is_playing>("is_playing", "False once it was stopped or has come to its end, by the game's time.");
}

void rows_sound(Area& a) {
  a.method<play_component>("play", "Plays it from the beginning.").acts();
  a.method<stop_component>("stop", "Ends it.").acts();
}

void rows_sound_groups(Area&) {}

void open_sound_groups(lua_State* L) {
  push_metatable(L, Tag::sound_groups);
  lua_pushcfunction(L, groups_index);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, groups_newindex);
  lua_setfield(L, -2, "__newindex");
  lua_pop(L, 1);
}

}  // namespace tumble
