-- A game's files: each runs once in an environment of its own; a run is all of them from one reading of their texts.
return function(parts)
  local core, names = parts.core, parts.names
  local files = {}
  files.live = nil                   -- the run that the game plays
  files.current = nil                -- the run being declared, while there is one

  function files.new_run()
    -- order: files as they finished; texts: by path; slots: node -> handlers; modules: path -> file
    return { modules = {}, order = {}, texts = {}, slots = {}, classes = {} }
  end

  -- The environment of a file: its own functions; behind them what every file sees; behind that an error. Names of the
  -- engine are not in the environment itself, so that an assignment to one is noticed wherever it stands.
  local function environment(file)
    local env, declared, known = {}, {}, {}
    file.declared = declared
    for name, value in pairs(core.globals) do known[name] = value end
    setmetatable(known, { __index = function(_, name)
      local list = {}
      for one in pairs(known) do list[#list + 1] = one end
      for one in pairs(env) do list[#list + 1] = one end
      table.sort(list)
      local near = core.nearest(tostring(name), list)
      core.raise(("unknown name '%s'%s"):format(tostring(name), near and ("; did you mean '%s'?"):format(near)
        or "; declare it with `local` at the top of the file, above its first use"))
    end })
    return setmetatable(env, {
      __index = known,
      __newindex = function(_, name, value)
        if core.globals[name] ~= nil then
          core.raise(("'%s' belongs to the engine; give yours another name, or write `local %s`"):format(name, name))
        elseif type(value) == "function" and file.running then
          rawset(env, name, value)
          declared[name] = true
        else
          core.raise(("'%s' is not declared; write `local %s = %s` at the top of the file"):format(tostring(name),
            tostring(name), core.short(value)))
        end
      end,
      __pairs = function()
        local all = {}
        for name in pairs(known) do all[name] = known[name] end
        for name in next, env do all[name] = env[name] end
        return core.pairs(all)
      end,
      __metatable = "environment",
    })
  end

  local function check_handlers(run)
    for _, file in ipairs(run.order) do
      for name in pairs(file.declared) do
        names.check_handler(name, names.main_list, names.main, file.path, run.texts)
      end
    end
    for _, class in ipairs(run.classes) do
      for name, value in pairs(class.methods) do
        if type(value) == "function" then
          names.check_handler(name, names.behaviour_list, names.behaviour, class.file.path, run.texts)
        end
      end
    end
  end
  files.check_handlers = check_handlers

  -- Runs a file's text in the run; errors pass through.
  function files.run_file(run, path, text)
    local file = { path = path, running = true }
    run.modules[path] = file
    run.texts[path] = text
    file.env = environment(file)
    local chunk, message = core.compile(text, path, file.env)
    if not chunk then error(message, 0) end
    file.chunk = chunk
    local outer_path, outer_file = core.set_file(path), run.file
    run.file = file
    file.value = chunk()
    core.set_file(outer_path)
    run.file = outer_file
    file.running = false
    run.order[#run.order + 1] = file
    return file
  end

  -- The text of a file by the name that `require` takes: in the game, then in scripts/std.
  local function find_text(run, name)
    local path = name:gsub("%.lua$", "") .. ".lua"
    local text = core.read(path)
    if text then return path, text end
    text = core.read_std(name)
    if text then return "std/" .. path, text end
  end

  function files.exists(name) return find_text(nil, name) ~= nil end

  function files.module(run, name)
    if type(name) ~= "string" then core.raise("require: a file's name expected, got " .. core.short(name)) end
    if name:find("..", 1, true) or name:sub(1, 1) == "/" then
      core.raise(("require: '%s' is outside the game; name a file of the game folder or of scripts/std"):format(name))
    end
    name = name:gsub("%.lua$", "")
    local path = name .. ".lua"
    local file = run.modules[path] or run.modules["std/" .. path]
    if file then
      if file.running then core.raise(("require: '%s' and this file need each other; move what both need into a third file"):format(name)) end
      return file
    end
    local found, text = find_text(run, name)
    if not found then
      local near = core.nearest(name, core.list_scripts())
      core.raise(("require: no file '%s.lua' in the game or in scripts/std%s"):format(name, near and ("; did you mean '%s'?"):format(near) or ""))
    end
    return files.run_file(run, found, text)
  end

  core.globals.require = function(name)
    local run = files.current or files.live
    if not files.current and not (run.modules[tostring(name) .. ".lua"] or run.modules["std/" .. tostring(name) .. ".lua"]) then
      core.raise(("require: '%s' must be asked for at the top of a file, not in a function"):format(tostring(name)))
    end
    local file = files.module(run, name)
    if file.value == nil then return true end
    return file.value
  end

  return files
end
