-- Calls handlers: main.lua's, behaviours', slots on nodes. Each call is protected; what fails stops until the next save.
return function(parts)
  local core, files, behaviours, tasks, names = parts.core, parts.files, parts.behaviours, parts.tasks, parts.names
  local boot, handlers = parts.boot, {}
  local records = behaviours.records
  local main_stopped = {}            -- names of main.lua's handlers that failed
  local slot_stopped = {}            -- node -> { name -> true }
  local lists = {}                   -- method -> { subjects, functions }, in tree order

  local function main_function(name)
    local file = files.live and files.live.main
    local fn = file and rawget(file.env, name)
    return not main_stopped[name] and type(fn) == "function" and file.declared[name] and fn or nil
  end

  local function stop(instance) records[instance].stopped = true end

  -- A method of an instance, if it has it.
  function handlers.call(instance, method, ...)
    local record = records[instance]
    local fn = rawget(record.class, method)
    if not fn or record.stopped then return false end
    local outer = tasks.owner
    tasks.owner = instance
    local ok = core.protected(fn, instance, ...)
    tasks.owner = outer
    if not ok then stop(instance) end
    return true
  end

  function handlers.call_main(name, ...)
    local fn = main_function(name)
    if not fn then return false end
    if not core.protected(fn, ...) then main_stopped[name] = true end
    return true
  end

  local function call_slot(node, name, ...)
    local slots = files.live and files.live.slots[node]
    local fn = slots and slots[name]
    if not fn or (slot_stopped[node] and slot_stopped[node][name]) then return false end
    if not core.protected(fn, ...) then
      slot_stopped[node] = slot_stopped[node] or {}
      slot_stopped[node][name] = true
    end
    return true
  end

  local function sorted_names(node)
    local list = {}
    for name in pairs(behaviours.instances[node] or {}) do list[#list + 1] = name end
    table.sort(list)
    return list
  end

  local scripted                     -- nodes with behaviours or slots, in tree order
  local function refresh()
    if core.take_lists_changed() then lists, scripted = {}, nil end
  end
  local function nodes()
    refresh()
    scripted = scripted or core.scripted_nodes()
    return scripted
  end

  -- ---- per tick: all that have the method, in tree order, at a node the slot first, then behaviours by name
  local function build(method)
    local subjects, functions, slot_of = {}, {}, {}   -- subjects: an instance, or false for a slot of slot_of[i]
    local live_slots = files.live and files.live.slots or {}
    for _, node in ipairs(nodes()) do
      local slots = live_slots[node]
      if slots and slots[method] and not (slot_stopped[node] and slot_stopped[node][method]) then
        subjects[#subjects + 1] = false
        slot_of[#subjects] = node
        functions[#functions + 1] = slots[method]
      end
      for _, name in ipairs(sorted_names(node)) do
        local instance = behaviours.instances[node][name]
        local record = records[instance]
        local fn = not record.fresh and not record.stopped and rawget(record.class, method)
        if fn then
          subjects[#subjects + 1] = instance
          functions[#functions + 1] = fn
        end
      end
    end
    return { subjects, functions, slot_of }
  end

  local function list_of(method)
    refresh()
    local list = lists[method]
    if not list then
      list = build(method)
      lists[method] = list
    end
    return list[1], list[2], list[3]
  end

  -- One protected call around the whole loop; after a failure it goes on behind the one that failed.
  local at
  local function loop(subjects, functions, slot_of, dt)
    while at < #subjects do
      at = at + 1
      local subject = subjects[at]
      if not subject then
        if core.alive(slot_of[at]) then functions[at](dt) end
      elseif subject.enabled and records[subject].alive then
        tasks.owner = subject
        functions[at](subject, dt)
      end
    end
  end

  local function run_all(method, dt)
    local subjects, functions, slot_of = list_of(method)
    at = 0
    while at < #subjects do
      if not core.protected(loop, subjects, functions, slot_of, dt) then
        if subjects[at] then
          stop(subjects[at])
        else
          slot_stopped[slot_of[at]] = slot_stopped[slot_of[at]] or {}
          slot_stopped[slot_of[at]][method] = true
        end
        core.lists_changed()
      end
    end
    tasks.owner = nil
  end

  function boot.update(dt)
    handlers.call_main("update", dt)
    run_all("update", dt)
  end
  function boot.late_update(dt)
    handlers.call_main("late_update", dt)
    run_all("late_update", dt)
  end

  function boot.frame(dt)
    local subjects = list_of("frame")
    if not main_function("frame") and #subjects == 0 then return end
    local state = parts.frame_state.take(subjects)
    handlers.call_main("frame", dt)
    run_all("frame", dt)
    local changed = parts.frame_state.restore(state)
    if changed then
      main_stopped.frame = true
      for _, subject in ipairs(subjects) do if subject then stop(subject) end end
      core.report(changed .. "; it runs once a picture, not once a tick, and only draws: change things in update or late_update", "")
    end
  end
  function boot.draw_ui(paused)
    handlers.call_main("draw_ui")
    if not paused then run_all("draw_ui") end
  end
  function boot.tasks() tasks.run() end

  -- ---- input: main.lua, and behaviours unless paused
  function boot.input(paused, name, ...)
    handlers.call_main(name, ...)
    if paused then return end
    for _, node in ipairs(nodes()) do
      for _, behaviour in ipairs(sorted_names(node)) do
        local instance = behaviours.instances[node] and behaviours.instances[node][behaviour]
        if instance and instance.enabled and not records[instance].fresh then handlers.call(instance, name, ...) end
      end
    end
  end

  -- The next press goes to one function alone.
  local listener
  handlers.input = {
    listen = function(fn)
      core.permit_act("input.listen")
      if type(fn) ~= "function" then core.raise("input.listen: fn: function expected, got " .. core.short(fn)) end
      listener = fn
      core.listen()
    end,
  }
  function boot.heard(name)
    local fn = listener
    listener = nil
    core.protected(fn, name)
  end
  -- Functions that have a new text.
  function handlers.sweep(replaced) listener = replaced[listener] or listener end

  -- Is there a function of that name in main.lua or in a behaviour's class?
  function boot.handles(name)
    if main_function(name) then return true end
    for _, class in ipairs(files.live and files.live.classes or {}) do
      if rawget(class.methods, name) then return true end
    end
    return false
  end

  -- ---- events at one node
  function boot.event(node, name, ...)
    call_slot(node, name, ...)
    for _, behaviour in ipairs(sorted_names(node)) do
      local instance = behaviours.instances[node] and behaviours.instances[node][behaviour]
      if instance and instance.enabled then handlers.call(instance, name, ...) end
    end
  end

  -- Does anything at the node hear that event? Stays are only asked for where something does.
  function boot.hears(node, name)
    local slots = files.live and files.live.slots[node]
    if slots and slots[name] then return true end
    for _, instance in pairs(behaviours.instances[node] or {}) do
      if rawget(records[instance].class, name) then return true end
    end
    return false
  end

  -- ---- messages
  local noted = {}
  local function check_message(message)
    if type(message) ~= "string" then core.raise("send: a message's name expected, got " .. core.short(message)) end
  end
  local function known_messages()
    local list, set = {}, {}
    local function take(name)
      if name:sub(1, 3) == "on_" and not set[name] then
        set[name] = true
        list[#list + 1] = name:sub(4)
      end
    end
    for _, file in ipairs(files.live.order) do for name in pairs(file.declared) do take(name) end end
    for _, class in ipairs(files.live.classes) do for name in pairs(class.methods) do take(name) end end
    for _, slots in pairs(files.live.slots) do for name in pairs(slots) do take(name) end end
    table.sort(list)
    return list, set
  end
  local function unheard(message)
    local list, set = known_messages()
    if set["on_" .. message] then return end
    local near = core.nearest(message, list)
    if near then core.raise(("send: nobody handles '%s'; did you mean '%s'?"):format(message, near)) end
    if not noted[message] and not core.called_from_std() then   -- a std file tells whoever wants to hear
      noted[message] = true
      core.log("note", ("message '%s' was sent and nothing handles it (no function on_%s)"):format(message, message))
    end
  end

  local function send_to_node(node, name, ...)
    local heard = call_slot(node, name, ...)
    for _, behaviour in ipairs(sorted_names(node)) do
      local instance = behaviours.instances[node] and behaviours.instances[node][behaviour]
      if instance and handlers.call(instance, name, ...) then heard = true end
    end
    return heard
  end

  function boot.send(node, message, ...)
    check_message(message)
    local name, heard = "on_" .. message, false
    if node then
      heard = send_to_node(node, name, ...)
    else
      heard = handlers.call_main(name, ...)
      for _, each in ipairs(nodes()) do
        if send_to_node(each, name, ...) then heard = true end
      end
    end
    if not heard then unheard(message) end
    return heard
  end

  -- ---- slots: function ball.on_collision_enter(hit)
  local function slots_of(node)
    local run = files.current or files.live
    run.slots[node] = run.slots[node] or {}
    return run.slots[node]
  end
  local function is_slot(name) return names.slot[name] or name == "update" or name == "late_update" or name:sub(1, 3) == "on_" end

  function boot.get_slot(node, name)
    if not is_slot(name) then return false end
    local run = files.current or files.live
    return true, run.slots[node] and run.slots[node][name]
  end

  function boot.set_slot(node, name, fn)
    if not is_slot(name) then return false end
    if fn ~= nil and type(fn) ~= "function" then
      core.raise(("node.%s: function expected, got %s"):format(name, core.short(fn)))
    end
    if not names.slot[name] and name:sub(1, 3) == "on_" then
      local near = core.nearest(name, names.slot_list)
      if near then core.raise(("no event '%s'; did you mean '%s'?"):format(name, near)) end
    end
    slots_of(node)[name] = fn
    if not files.current then
      core.mark(node, true)
      if slot_stopped[node] then slot_stopped[node][name] = nil end
      core.lists_changed()
    end
    return true
  end

  function boot.forget(node)
    if files.live then files.live.slots[node] = nil end
    slot_stopped[node] = nil
    behaviours.forget(node)
  end

  -- A good save gives everything that had failed another chance.
  function handlers.forgive()
    main_stopped, slot_stopped = {}, {}
    core.lists_changed()
  end

  function boot.attach(node, name, given, where) behaviours.attach(node, name, given, where) end
  function boot.declare(node, name, given)
    behaviours.declare(node, name, given)
    behaviours.refresh({})
  end
  function boot.check_behaviour(name, given, where) behaviours.check(name, given, where) end
  function boot.start_new() behaviours.start_new() end
  function boot.behaviours(node) return behaviours.view(node) end
  function boot.saved_behaviours(node) return behaviours.saved(node) end
  function boot.restart_node(node, declared) behaviours.restart(node, declared) end
  function boot.destroyed(node)
    for _, name in ipairs(sorted_names(node)) do
      local instance = behaviours.instances[node][name]
      handlers.call(instance, "on_destroy")
      records[instance].alive = false
    end
  end

  return handlers
end
