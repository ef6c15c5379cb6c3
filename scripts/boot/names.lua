-- Handler names: which there are, and what to say of one that is nearly right.
return function(parts)
  local core = parts.core
  local names = {}

  names.node_events = {
    "on_collision_enter", "on_collision_stay", "on_collision_exit", "on_trigger_enter", "on_trigger_stay",
    "on_trigger_exit", "on_joint_break", "on_animation_end", "on_sleep", "on_wake",
  }
  names.input_events = { "on_press", "on_release", "on_pointer_move", "on_wheel", "on_text" }
  names.file_events = { "on_scene_start", "on_reload" }
  names.behaviour_events = { "on_reload", "on_destroy" }
  names.phases = { "start", "update", "late_update", "frame", "draw_ui" }

  -- A set and a list of all the events in some of the lists above.
  local function union(...)
    local list, set = {}, {}
    for _, part in ipairs { ... } do
      for _, name in ipairs(part) do
        if not set[name] then
          set[name] = true
          list[#list + 1] = name
        end
      end
    end
    return list, set
  end
  names.main_list, names.main = union(names.input_events, names.file_events)
  names.behaviour_list, names.behaviour = union(names.node_events, names.input_events, names.behaviour_events)
  names.slot_list, names.slot = union(names.node_events)

  -- A function on_... that is no event must be a message that some text sends; one that is near to an event and
  -- never sent is a typing error.
  function names.check_handler(name, list, set, where, texts)
    if set[name] or name:sub(1, 3) ~= "on_" then return end
    if names.slot[name] then
      error(("%s: '%s' happens to a node: write function ball.%s(hit) for a node 'ball', or give it to a behaviour"):format(where, name, name), 0)
    end
    local message = name:sub(4)
    for _, text in pairs(texts) do
      if text:find('"' .. message .. '"', 1, true) or text:find("'" .. message .. "'", 1, true) then return end
    end
    local near = core.nearest(name, list)
    if near then error(("%s: no event '%s'; did you mean '%s'?"):format(where, name, near), 0) end
  end

  return names
end
