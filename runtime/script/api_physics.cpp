// Queries and settings of the world; hits and filters.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "engine/shape_files.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

// ---- filters

struct FilterData {
  QueryFilter filter;
};

namespace {

std::vector<std::string> words(const Value& value, const std::string& where) {
  std::vector<std::string> list;
  assign(type_of<std::vector<std::string>>(), &list, value, where);
  return list;
}

std::vector<NodeId> nodes(lua_State* L, int index, const std::string& where) {
  std::vector<NodeId> list;
  auto take = [&](int at) {
    const NodeId* node = object_at<NodeId>(L, at, Tag::node);
    if (!node) fail(where, ": node or list of nodes expected, got ", describe_argument(L, at));
    list.push_back(*node);
  };
  if (!lua_istable(L, index)) return take(index), list;
  for (lua_Integer i = 1; i <= static_cast<lua_Integer>(lua_rawlen(L, index)); ++i) {
    lua_rawgeti(L, index, i);
    take(-1);
    lua_pop(L, 1);
  }
  return list;
}

// One of the nodes, or below one of them.
bool among(Script& s, NodeId node, const std::vector<NodeId>& list) {
  return std::any_of(list.begin(), list.end(), [&](NodeId one) { return s.engine().scene.is_inside(node, one); });
}

bool call_accept(Script& s, int reference, NodeId node) {
  lua_State* L = s.stack();
  lua_rawgeti(L, LUA_REGISTRYINDEX, reference);
  s.push_node(node);
  lua_call(L, 1, 1);
  const bool yes = lua_toboolean(L, -1);
  lua_pop(L, 1);
  return yes;
}

struct Parts {
  std::vector<std::string> tags;
  std::vector<NodeId> ignore, only;
  std::shared_ptr<int> accept;  // a reference in the registry, freed with the last copy
};

QueryFilter read_filter(Script& s, lua_State* L, int index, const std::string& call) {
  QueryFilter filter;
  auto parts = std::make_shared<Parts>();
  static const std::vector<std::string> known = {"groups", "tags", "ignore", "only", "triggers", "accept"};
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    const std::string key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : describe_argument(L, -2);
    const std::string where = call + ": filter." + key;
    if (key == "groups") {
      filter.groups = 0;
      for (const std::string& group : words(value_from_lua(L, -1, where), where))
        filter.groups |= s.engine().world() ? s.engine().world()->group_bit(group) : 0;
    } else if (key == "tags") {
      parts->tags = words(value_from_lua(L, -1, where), where);
    } else if (key == "ignore") {
      parts->ignore = nodes(L, lua_gettop(L), where);
    } else if (key == "only") {
      parts->only = nodes(L, lua_gettop(L), where);
    } else if (key == "triggers") {
      if (!lua_isboolean(L, -1)) fail(where, ": boolean expected, got ", describe_argument(L, -1));
      filter.triggers = lua_toboolean(L, -1);
    } else if (key == "accept") {
      if (!lua_isfunction(L, -1)) fail(where, ": function expected, got ", describe_argument(L, -1));
      lua_pushvalue(L, -1);
      lua_State* main = s.lua();
      parts->accept = std::shared_ptr<int>(new int(luaL_ref(L, LUA_REGISTRYINDEX)), [main](int* reference) {
        luaL_unref(main, LUA_REGISTRYINDEX, *reference);
        delete reference;
      });
    } else {
      fail(call, ": filter has no field '", key, "'", did_you_mean(key, known));
    }
  }
  if (parts->tags.empty() && parts->ignore.empty() && parts->only.empty() && !parts->accept) return filter;
  filter.accept = [&s, parts](BodyId body) {
    const NodeId node = s.engine().node_of(body);
    const SceneNode* n = s.engine().scene.get(node);
    if (!n) return false;
    const auto has = [&](const std::string& tag) { return std::find(n->tags.begin(), n->tags.end(), tag) != n->tags.end(); };
    if (!parts->tags.empty() && std::none_of(parts->tags.begin(), parts->tags.end(), has)) return false;
    if (!parts->only.empty() && !among(s, node, parts->only)) return false;
    if (among(s, node, parts->ignore)) return false;
    return !parts->accept || call_accept(s, *parts->accept, node);
  };
  return filter;
}

int free_hit(lua_State* L) {
  hit_at(L, 1)->~HitData();
  return 0;
}

int free_filter(lua_State* L) {
  object_at<FilterData>(L, 1, Tag::filter)->~FilterData();
  return 0;
}

}  // namespace

QueryFilter LuaType<QueryFilter>::read(Arguments& a) {
  ++a.number;
  if (FilterData* kept = object_at<FilterData>(a.L, a.index, Tag::filter)) {
    ++a.index;
    return kept->filter;
  }
  if (!lua_istable(a.L, a.index)) a.bad("filter");
  return read_filter(a.script, a.L, a.index++, a.row.full_name());
}
int LuaType<QueryFilter>::push(lua_State* L, const QueryFilter& v) { return push_object(L, Tag::filter, FilterData{v}), 1; }

bool Script::shows_queries() const {
  const DebugView view = live_settings_.debug_view;
  return (view == DebugView::rays || view == DebugView::physics) && (phase_ == Phase::run || phase_ == Phase::frame);
}

// In a game without a body rays hit nothing.
World& Script::world_or_empty() {
  if (World* world = engine().world()) return *world;
  if (!empty_world_) empty_world_ = std::make_unique<World>(WorldSettings{});
  return *empty_world_;
}

// ---- hits

void push_hit(lua_State* L, const HitData& hit) { push_object(L, Tag::hit, hit); }
HitData* hit_at(lua_State* L, int index) { return object_at<HitData>(L, index, Tag::hit); }

HitData Script::hit_of(const ContactEvent& event, BodyId self) const {
  const bool is_a = event.a == self;
  HitData hit;
  hit.kind = event.trigger ? HitData::Kind::trigger : HitData::Kind::collision;
  const auto [a, b] = live_.nodes_of(event);
  hit.own = is_a ? a : b;
  hit.node = is_a ? b : a;
  hit.collider = (is_a ? event.collider_b : event.collider_a) + 1;
  hit.own_collider = (is_a ? event.collider_a : event.collider_b) + 1;
  hit.point = event.point;
  hit.normal = is_a ? -event.normal : event.normal;   // towards me
  hit.velocity = is_a ? event.velocity : -event.velocity;
  hit.speed = event.speed;
  hit.impulse = event.impulse;
  hit.points = event.points;
  return hit;
}

namespace {

HitData query_hit(Script& s, const QueryHit& found, Vec3 origin, Vec3 end) {
  HitData hit;
  hit.kind = HitData::Kind::query;
  hit.node = s.engine().node_of(found.body);
  hit.collider = found.collider + 1;
  hit.point = found.point;
  hit.normal = found.normal;
  hit.distance = found.distance;
  hit.time = s.seconds_now;
  hit.origin = origin;
  hit.end = end;
  return hit;
}

AnyNode hit_node(Script&, HitRef h) { return {h.hit->node}; }
Results hit_body(Script& s, HitRef h) {
  if (s.engine().scene.get(h.hit->node) && s.engine().body(h.hit->node)) s.push_component(h.hit->node, Tag::body);
  else lua_pushnil(s.stack());
  return {1};
}
int hit_collider(Script&, HitRef h) { return h.hit->collider; }
int hit_own_collider(Script&, HitRef h) { return h.hit->own_collider; }
Vec3 hit_point(Script&, HitRef h) { return h.hit->point; }
Vec3 hit_normal(Script&, HitRef h) {
  if (h.hit->kind == HitData::Kind::trigger) fail("hit.normal: a trigger has no surface; use hit.point or hit.velocity");
  return h.hit->normal;
}
double hit_speed(Script&, HitRef h) { return h.hit->speed; }
double hit_impulse(Script&, HitRef h) {
  if (h.hit->kind == HitData::Kind::trigger) fail("hit.impulse: a trigger pushes nobody and has no impulse");
  return h.hit->impulse;
}
double hit_time(Script&, HitRef h) {
  if (h.hit->kind == HitData::Kind::collision) fail("hit.time: a collision does not tell a moment within its tick, a trigger does; use time.now");
  return h.hit->time;
}
Vec3 hit_velocity(Script&, HitRef h) { return h.hit->velocity; }
double hit_distance(Script&, HitRef h) { return h.hit->distance; }
Vec3 hit_origin(Script&, HitRef h) { return h.hit->origin; }
Vec3 hit_end(Script&, HitRef h) { return h.hit->end; }
std::vector<Vec3> hit_points(Script&, HitRef h) {
  std::vector<Vec3> points;
  for (const ContactPoint& point : h.hit->points) points.push_back(point.point);
  return points;
}

// ---- queries

World& need_world(Script& s) { return s.world_or_empty(); }

Vec3 direction_or_fail(Vec3 direction, const char* call) {
  if (direction == Vec3{}) fail(call, ": direction must not be zero (got 0, 0, 0); give a direction such as node.forward");
  return normalized(direction);
}

// A length in metres: above 0, and infinity is allowed.
struct Length { double metres; };

}  // namespace

template <>
struct LuaType<Length> {
  static constexpr bool optional = false;
  static std::string name() { return "number"; }
  static Length read(Arguments& a) {
    ++a.number;
    if (lua_type(a.L, a.index) != LUA_TNUMBER) a.bad("number");
    const double length = lua_tonumber(a.L, a.index++);
    if (!(length > 0)) a.wrong("a length above 0 expected, got " + number_text(length));
    return {std::min(length, 1e6)};   // beyond, doubles in casts lose the hit point
  }
};

namespace {

using MaybeFilter = std::optional<QueryFilter>;

void note_query(Script& s, Vec3 from, Vec3 to, double stop, const std::vector<QueryHit>& hits, const Shape* shape = nullptr) {
  DebugQuery query{from, to, stop, {}, {}};
  if (shape) query.shape = *shape;
  for (const QueryHit& hit : hits) query.hits.emplace_back(hit.point, hit.normal);
  s.drawing().queries.push_back(std::move(query));
}

Results push_maybe_hit(Script& s, const std::optional<QueryHit>& found, Vec3 origin, Vec3 end, const Shape* shape = nullptr) {
  if (s.shows_queries()) note_query(s, origin, end, found ? found->distance : distance(origin, end), found ? std::vector{*found} : std::vector<QueryHit>{}, shape);
  if (found) push_hit(s.stack(), query_hit(s, *found, origin, end));
  else lua_pushnil(s.stack());
  return {1};
}

Results raycast(Script& s, Vec3 origin, Vec3 direction, Length length, MaybeFilter filter) {
  direction = direction_or_fail(direction, "physics.raycast");
  return push_maybe_hit(s, need_world(s).raycast(origin, direction, length.metres, filter.value_or(QueryFilter{})), origin,
                        origin + direction * length.metres);
}
Results raycast_to(Script& s, Vec3 from, Vec3 to, MaybeFilter filter) {
  if (from == to) return lua_pushnil(s.stack()), Results{1};
  return push_maybe_hit(s, need_world(s).raycast(from, normalized(to - from), distance(from, to), filter.value_or(QueryFilter{})), from, to);
}
Results raycast_all(Script& s, Vec3 origin, Vec3 direction, Length length, MaybeFilter filter) {
  direction = direction_or_fail(direction, "physics.raycast_all");
  lua_State* L = s.stack();
  const std::vector<QueryHit> hits = need_world(s).raycast_all(origin, direction, length.metres, filter.value_or(QueryFilter{}));
  if (s.shows_queries()) note_query(s, origin, origin + direction * length.metres, length.metres, hits);
  lua_newtable(L);
  lua_Integer n = 0;
  for (const QueryHit& found : hits) {
    push_hit(L, query_hit(s, found, origin, origin + direction * length.metres));
    lua_rawseti(L, -2, ++n);
  }
  return {1};
}
bool raycast_any(Script& s, Vec3 origin, Vec3 direction, Length length, MaybeFilter filter) {
  direction = direction_or_fail(direction, "physics.raycast_any");
  if (s.shows_queries()) note_query(s, origin, origin + direction * length.metres, length.metres, {});
  return need_world(s).raycast_any(origin, direction, length.metres, filter.value_or(QueryFilter{}));
}
Results pick(Script& s, MaybeFilter filter) {
  const CameraView view = camera_view(s.engine());
  const auto [from, direction] = camera_ray(view, s.engine().input.pointer_x, s.engine().input.pointer_y, s.aspect);
  return push_maybe_hit(s, need_world(s).raycast(from, direction, view.far, filter.value_or(QueryFilter{})), from, from + direction * view.far);
}
// A model counts with all that is inside its hull.
Shape solid(Script& s, Shape shape) {
  shape = settled(shape);
  if (shape.shape == ShapeKind::mesh) shape.shape = ShapeKind::hull;
  return s.engine().with_points(shape);
}

Results cast(Script& s, Shape shape, Vec3 origin, Vec3 direction, Length length, MaybeFilter filter) {
  direction = direction_or_fail(direction, "physics.cast");
  shape = solid(s, shape);
  return push_maybe_hit(s, need_world(s).cast(shape, {origin, {}}, direction, length.metres, filter.value_or(QueryFilter{})), origin,
                        origin + direction * length.metres, &shape);
}
std::vector<NodeRef> overlap(Script& s, Shape shape, Vec3 position, MaybeFilter filter) {
  shape = solid(s, shape);
  if (s.shows_queries()) note_query(s, position, position, 0, {}, &shape);
  std::vector<NodeRef> found;
  for (const BodyId body : need_world(s).overlap(shape, {position, {}}, filter.value_or(QueryFilter{}))) found.push_back({s.engine().node_of(body)});
  return found;
}
Results penetrations(Script& s, Shape shape, Vec3 position, double within, MaybeFilter filter) {
  lua_State* L = s.stack();
  shape = solid(s, shape);
  const std::vector<QueryHit> hits = need_world(s).penetrations(shape, {position, {}}, within, filter.value_or(QueryFilter{}));
  if (s.shows_queries()) note_query(s, position, position, 0, hits, &shape);
  lua_newtable(L);
  lua_Integer n = 0;
  for (const QueryHit& found : hits) {
    push_hit(L, query_hit(s, found, position, position));
    lua_rawseti(L, -2, ++n);
  }
  return {1};
}
QueryFilter filter(Script&, QueryFilter filter) { return filter; }

}  // namespace

void rows_physics(Area& a) {
  a.fn<raycast>("raycast", "The first body that the ray hits, or nil. The direction may have any length but zero.", "origin", "direction", "length", "filter").queries().gives("hit or nil");
  a.fn<raycast_to>("raycast_to", "The first body between two points, or nil.", "from", "to", "filter").queries().gives("hit or nil");
  a.fn<raycast_all>("raycast_all", "All bodies that the ray hits, by distance.", "origin", "direction", "length", "filter").queries().gives("list of hit");
  a.fn<raycast_any>("raycast_any", "Does the ray hit anything?", "origin", "direction", "length", "filter").queries();
  a.fn<pick>("pick", "The first body under the pointer, or nil.", "filter").queries().gives("hit or nil");
  a.fn<cast>("cast", "The first body that a moving shape touches, or nil.", "shape", "origin", "direction", "length", "filter").queries().gives("hit or nil");
  a.fn<overlap>("overlap", "The nodes of the bodies that a shape touches.", "shape", "position", "filter").queries();
  a.fn<penetrations>("penetrations", "How a shape lies against the bodies around it: a hit each, with the distance between the surfaces (negative: they overlap) and the normal that leads out.", "shape", "position", "within", "filter").queries().gives("list of hit");
  a.fn<filter>("filter", "Compiles a filter to keep: { groups, tags, ignore, only, triggers = false, accept = function(node) end }.", "filter");
  rows_physics_settings(a);
}

void rows_hit(Area& a) {
  a.prop<hit_node>("node", "The other's node; of a query, the node that was hit.");
  a.prop<hit_body>("body", "Its body.").gives("body or nil");
  a.prop<hit_collider>("collider", "Which of its colliders, counted from 1.");
  a.prop<hit_own_collider>("own_collider", "Which of mine, counted from 1.");
  a.prop<hit_point>("point", "Where, in the world, m.");
  a.prop<hit_normal>("normal", "The surface's direction towards me, or towards the ray's origin.");
  a.prop<hit_speed>("speed", "How fast they approached when the tick began, m/s.");
  a.prop<hit_impulse>("impulse", "What they pushed each other with in this tick, N s.");
  a.prop<hit_velocity>("velocity", "The other's velocity against mine, m/s.");
  a.prop<hit_time>("time", "Of a trigger: when the shapes first or last touched, s on the clock of time.now, exact within the tick for what flies freely in it; of a stay or a query, time.now. A collision tells none.");
  a.prop<hit_distance>("distance", "Of a query: how far from the origin, m.");
  a.prop<hit_origin>("origin", "Of a query: where it began.");
  a.prop<hit_end>("end_point", "Of a query: where it would have ended.");
  a.method<hit_points>("points", "All points where they touch.");
}

void rows_filter(Area&) {}

void open_hit_collection(lua_State* L) {
  push_metatable(L, Tag::hit);
  lua_pushcfunction(L, free_hit);
  lua_setfield(L, -2, "__gc");
  push_metatable(L, Tag::filter);
  lua_pushcfunction(L, free_filter);
  lua_setfield(L, -2, "__gc");
  lua_pop(L, 2);
}

}  // namespace tumble
