-- Runs a game's text, and runs it again when it changed, keeping what the game has become meanwhile.
--
-- The rule (docs/guide/reload.md): run the whole text into a staging copy; apply what differs from the last run. Nodes,
-- joints and settings are compared by the engine (core.commit); here are functions, locals, tables and classes.
-- A variable is the cell that a local lives in, shared by the functions that use it. It is found again by its name and
-- by who uses it; its new functions are joined to the old cell, so that old and new code see one value.
return function(parts)
  local core, files, behaviours, handlers, tasks, boot = parts.core, parts.files, parts.behaviours, parts.handlers, parts.tasks, parts.boot
  local debug = core.debug
  local variables = parts.variables
  local collect, equal, find_old, merge = variables.collect, variables.equal, variables.find_old, variables.merge
  local reload = {}

  -- ---- committing one run over another
  local function commit_variable(state, variable, match)
    local _, live = debug.getupvalue(match.fn, match.index)
    local _, fresh = debug.getupvalue(variable.fn, variable.index)
    local value = live
    if type(fresh) == "function" then
      if live == match.declared then value = fresh else value = state.replaced[live] or live end
    elseif type(fresh) == "table" and type(live) == "table" and type(match.initial) == "table" then
      merge(state, live, match.initial, fresh, variable.name)
    elseif not equal(match.initial, fresh) then
      value = fresh
      state.log[#state.log + 1] = ("%s = %s%s"):format(variable.name, core.short(fresh),
        core.same(live, match.initial) and "" or (" (was %s in play)"):format(core.short(live)))
    elseif type(live) == "function" and state.replaced[live] then
      value = state.replaced[live]
    end
    debug.setupvalue(match.fn, match.index, value)
    if type(fresh) == "function" then variable.declared = fresh end
  end

  -- Joins every new function to the old cells of the variables that live on.
  local function join(run, matches)
    for fn in pairs(run.functions) do
      for index = 1, 255 do
        local name = debug.getupvalue(fn, index)
        if not name then break end
        local variable = name ~= "_ENV" and run.variables[debug.upvalueid(fn, index)]
        local match = variable and matches[variable]
        if match then debug.upvaluejoin(fn, index, match.fn, match.index) end
      end
    end
  end

  local function join_environments(old, new)
    for fn in pairs(new.functions) do
      local before = old.modules[new.homes[fn]]
      for index = 1, before and 255 or 0 do
        local name = debug.getupvalue(fn, index)
        if not name then break end
        if name == "_ENV" then debug.upvaluejoin(fn, index, before.chunk, 1) end
      end
    end
  end

  local function join_variable_keepers(matches)
    for variable, match in pairs(matches) do variable.fn, variable.index = match.fn, match.index end
  end

  local function merge_environment(old_file, new_file)
    for name in pairs(old_file.declared) do
      if not new_file.declared[name] then rawset(old_file.env, name, nil) end
    end
    for name in pairs(new_file.declared) do rawset(old_file.env, name, rawget(new_file.env, name)) end
  end

  local function commit_files(old, new, state)
    for fn, path in pairs(old.functions) do state.old_paths[old.homes[fn] .. ":" .. path] = fn end
    for fn, path in pairs(new.functions) do
      local before = state.old_paths[new.homes[fn] .. ":" .. path]
      if before then state.replaced[before] = fn end
    end
    local taken, matches = {}, {}
    for _, variable in ipairs(new.variable_list) do
      local match = find_old(old, variable, taken)
      if match then
        taken[match] = true
        matches[variable] = match
      end
    end
    -- Classes first: their methods go into the living class tables, whatever variables hold them.
    for path, file in pairs(new.modules) do
      local before = old.modules[path]
      if before and type(before.value) == "table" and type(file.value) == "table" then
        merge(state, before.value, before.initial_value, file.value, path:gsub("%.lua$", ""))
        if behaviours.info(before.value) and behaviours.info(file.value) then
          local was, is = behaviours.info(before.value), behaviours.info(file.value)
          was.properties, was.file = is.properties, is.file
          for name in pairs(is.known) do was.known[name] = true end
        end
      end
    end
    for _, variable in ipairs(new.variable_list) do
      if matches[variable] then commit_variable(state, variable, matches[variable]) end
    end
    join(new, matches)
    join_variable_keepers(matches)
    for path, file in pairs(new.modules) do
      local before = old.modules[path]
      if before then
        merge_environment(before, file)
        debug.upvaluejoin(file.chunk, 1, before.chunk, 1)
        file.env = before.env
        if type(before.value) == "table" and type(file.value) == "table" then file.value = before.value end
      end
    end
    join_environments(old, new)
    for _, gone in ipairs(old.variable_list) do
      if not taken[gone] and new.modules[gone.file] and type(gone.initial) ~= "function" and type(gone.initial) ~= "table" and type(gone.initial) ~= "userdata" then
        local _, value = debug.getupvalue(gone.fn, gone.index)
        state.log[#state.log + 1] = ("local %s gone (was %s)"):format(gone.name, core.short(value))
      end
    end
  end

  -- What functions set on declared nodes in play (slots) stays, unless the text declares that slot itself.
  local function commit_slots(old, new)
    for node, slots in pairs(old.slots) do
      local mine = new.slots[node]
      for name, fn in pairs(slots) do
        local was_declared = old.declared_slots and old.declared_slots[node] and old.declared_slots[node][name]
        if not was_declared and not (mine and mine[name]) then
          new.slots[node] = new.slots[node] or {}
          mine = new.slots[node]
          mine[name] = fn
        end
      end
    end
  end

  local function note_declared_slots(run)
    run.declared_slots = {}
    for node, slots in pairs(run.slots) do
      run.declared_slots[node] = {}
      for name in pairs(slots) do run.declared_slots[node][name] = true end
    end
  end

  -- ---- running the text
  -- Declares everything into a fresh run. Returns the run, or nil after the failure was reported.
  local function stage(paths)
    local run = files.new_run()
    files.current = run
    core.begin_staging()
    local ok = core.protected(function()
      local entry = core.entry()
      if entry ~= "" and not core.read(entry) then error(entry .. ": the file is gone; the game goes on with the code from before", 0) end
      if entry ~= "" then run.main = files.module(run, (entry:gsub("%.lua$", ""))) end
      for _, path in ipairs(paths) do
        local name = path:gsub("^std/", ""):gsub("%.lua$", "")
        if not run.modules[path] and files.exists(name) then files.module(run, name) end
      end
      files.check_handlers(run)
      core.check_declarations()
    end)
    core.set_file("")
    if ok then collect(run, run.order) end
    files.current = nil
    if not ok then core.drop_staging() return nil end
    return run
  end

  local function adopt(result)
    for _, added in ipairs(result.added) do
      for _, name in ipairs(core.keys(added.behaviours)) do
        core.protected(behaviours.attach, added.node, name, added.behaviours[name], "scene.add")
      end
    end
    for _, change in ipairs(result.changed) do
      for _, name in ipairs(core.keys(change.behaviours)) do
        core.protected(behaviours.declare, change.node, name, change.behaviours[name])
      end
      for _, name in ipairs(core.keys(change.before)) do
        if change.behaviours[name] == nil then core.protected(behaviours.detach, change.node, name) end
      end
    end
  end

  local function mark_slots(run)
    for node in pairs(run.slots) do core.mark(node, true) end
  end

  -- The text of a file as this run read it.
  function boot.declared_text(path) return files.current and files.current.texts[path] end

  -- First load: false where the text is faulty.
  function boot.load()
    local run = stage({})
    if not run then return false end
    files.live = run
    note_declared_slots(run)
    adopt(core.commit(false))
    mark_slots(run)
    core.lists_changed()
    return true
  end
  function boot.start_main() handlers.call_main("start") end
  function boot.scene_started(name)
    handlers.call_main("on_scene_start", name)
  end

  -- A behaviour's file that nothing asked for before: runs into the living game.
  function reload.load_late(name)
    local outer_phase = core.begin_late()
    local run = files.live
    files.current = run
    core.begin_staging()
    local before = #run.order
    local file
    local ok = core.try(function() file = files.module(run, name) end)
    files.current = nil
    core.set_file("")
    if not ok.ok then
      run.modules[name .. ".lua"] = nil
      core.drop_staging()
      core.end_late(outer_phase)
      error(ok.message, 0)
    end
    adopt(core.commit(true))
    core.end_late(outer_phase)
    collect(run, table.move(run.order, before + 1, #run.order, 1, {}))     -- and what it requires, if nobody did before
    return file
  end

  local function known_paths(run)
    local list = {}
    for _, file in ipairs(run and run.order or {}) do list[#list + 1] = file.path end
    return list
  end

  -- The text changed. Returns whether it took, and what to say.
  function boot.reload()
    local old = files.live
    if not old then
      if not boot.load() then return false, "" end
      return true, "loaded"
    end
    local start_before = old.main and core.function_text(old.texts[core.entry()] or "", "start")
    local new = stage(known_paths(old))
    if not new then return false, "" end
    local state = { merged = {}, replaced = {}, old_paths = {}, log = {} }
    commit_files(old, new, state)
    commit_slots(old, new)
    note_declared_slots(new)
    for node, slots in pairs(new.slots) do
      for name, fn in pairs(slots) do
        if state.replaced[fn] then slots[name] = state.replaced[fn] end
      end
    end
    files.live = new
    local result = core.commit(false)
    tasks.sweep(state.replaced)
    handlers.sweep(state.replaced)
    adopt(result)
    behaviours.refresh(state.log)
    mark_slots(new)
    handlers.forgive()
    for _, line in ipairs(result.log) do table.insert(state.log, 1, line) end
    if start_before and core.function_text(new.texts[core.entry()] or "", "start") ~= start_before then
      state.log[#state.log + 1] = "start() changed: F5 runs it"
    end
    handlers.call_main("on_reload")
    for _, node in ipairs(core.scripted_nodes()) do
      for _, name in ipairs(core.keys(behaviours.instances[node] or {})) do
        handlers.call(behaviours.instances[node][name], "on_reload")
      end
    end
    return true, #state.log > 0 and table.concat(state.log, ", ") or "code only, all values kept"
  end

  return reload
end
