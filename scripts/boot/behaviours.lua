-- Behaviours: classes that files declare, and their instances on nodes.
return function(parts)
  local core, files = parts.core, parts.files
  local behaviours = {}
  local class_info = setmetatable({}, { __mode = "k" })   -- class table -> info
  local instances = {}               -- node -> { name -> instance }
  local fresh = {}                   -- instances whose start() has not run, oldest first
  -- instance -> what the engine knows of it, and scripts do not see: class, initial, given, alive, stopped ...
  local records = setmetatable({}, { __mode = "k" })
  behaviours.instances, behaviours.records = instances, records

  -- ---- declared properties
  local function declared(kind, default, extra)
    extra = extra or {}
    extra.kind, extra.default = kind, default
    return core.property(extra)
  end
  behaviours.property = {
    number = function(options)
      if type(options) ~= "table" or type(options[1]) ~= "number" then
        core.raise("property.number: write property.number { 6, min = 0, max = 20 }")
      end
      return declared("number", options[1], { min = options.min, max = options.max })
    end,
    choice = function(words)
      if type(words) ~= "table" or type(words[1]) ~= "string" then
        core.raise('property.choice: a list of words expected; write property.choice { "calm", "angry" }')
      end
      return declared("choice", words[1], { words = words })
    end,
    node = function() return declared("node", nil) end,
    asset = function(kind) return declared("asset", "", { asset = kind }) end,
  }

  local function property_of(value)
    local extra = core.property_of(value)
    if extra then return extra end
    return { kind = core.kind(value), default = value }
  end

  -- The value that a declared property takes, or an error: `given` comes from a script or a scene file.
  local function fit(property, given, where)
    local kind = property.kind
    local function wrong() core.raise(("%s: %s expected, got %s"):format(where, kind, core.short(given))) end
    if kind == "choice" then
      for _, word in ipairs(property.words) do if word == given then return given end end
      local near = type(given) == "string" and core.nearest(given, property.words)
      core.raise(("%s: one of %s expected, got %s%s"):format(where, table.concat(property.words, ", "), core.short(given),
        near and ("; did you mean '%s'?"):format(near) or ""))
    end
    if kind == "node" then
      if given == nil or core.kind(given) == "node" then return given end
      if type(given) == "string" then return core.find_node(given, where) end
      wrong()
    end
    if kind == "vec3" then
      local v = core.as_vec3(given)
      if not v then wrong() end
      return v
    end
    if kind == "color" then
      local c = core.as_color(given)
      if not c then wrong() end
      return c
    end
    if kind == "asset" then kind = "string" end
    if kind ~= "table" and kind ~= "nil" and core.kind(given) ~= kind then wrong() end
    if property.min and given < property.min or property.max and given > property.max then
      core.raise(("%s: %s to %s expected, got %s"):format(where, property.min or "-inf", property.max or "inf", core.short(given)))
    end
    return given
  end

  -- ---- classes
  local function sorted_keys(t)
    local keys = {}
    for key in pairs(t) do keys[#keys + 1] = key end
    table.sort(keys)
    return keys
  end

  core.globals.behaviour = function(properties)
    local run = files.current
    if not run then core.raise("behaviour: only at the top of a file") end
    if properties ~= nil and type(properties) ~= "table" then
      core.raise("behaviour: a table of properties expected, got " .. core.short(properties))
    end
    local class = {}
    local info = { methods = class, properties = {}, known = { node = true, enabled = true }, file = run.file }
    for _, name in ipairs(sorted_keys(properties or {})) do
      if type(name) ~= "string" then core.raise("behaviour: properties have names; write behaviour { speed = 2 }") end
      if name == "node" or name == "enabled" then core.raise(("behaviour: '%s' is built in and cannot be declared"):format(name)) end
      info.properties[name] = property_of(properties[name])
      info.known[name] = true
    end
    info.instance_meta = {
      __index = class,
      __newindex = function(instance, name, value)
        if info.known[name] or records[instance].starting then
          info.known[name] = true
          rawset(instance, name, value)
          return
        end
        local near = core.nearest(tostring(name), sorted_keys(info.known))
        core.raise(("%s has no field '%s'%s; set it in start() or declare it: behaviour { %s = %s }"):format(info.name or "this behaviour",
          tostring(name), near and ("; did you mean '%s'?"):format(near) or "", tostring(name), core.short(value)))
      end,
      __metatable = "behaviour",
      __name = "behaviour",
    }
    setmetatable(class, {
      __index = function(_, name)
        if info.known[name] then return nil end
        local list = sorted_keys(info.known)
        for method in pairs(class) do list[#list + 1] = method end
        local near = core.nearest(tostring(name), list)
        core.raise(("%s has no field '%s'%s"):format(info.name or "this behaviour", tostring(name),
          near and ("; did you mean '%s'?"):format(near) or "; set it in start()"))
      end,
      __metatable = "class",
    })
    class_info[class] = info
    run.classes[#run.classes + 1] = info
    return class
  end

  function behaviours.info(class) return class_info[class] end

  -- The class in the file of that name; the file runs where it has not yet.
  function behaviours.class(name, where)
    local run = files.current or files.live
    local file = run.modules[name .. ".lua"] or run.modules["std/" .. name .. ".lua"]
    if not file then
      if not files.exists(name) then
        local near = core.nearest(name, core.list_scripts())
        core.raise(("%s: no behaviour '%s': there is no file %s.lua in the game or in scripts/std%s"):format(where, name, name,
          near and ("; did you mean '%s'?"):format(near) or ""))
      end
      file = files.current and files.module(run, name) or parts.reload.load_late(name)
    end
    local info = class_info[file.value]
    if not info then core.raise(("%s: %s does not return a behaviour; end it with `return` and the class"):format(where, file.path)) end
    info.name = name
    return file.value, info
  end

  -- Values of all declared properties: the given ones checked, the others by default.
  local function fill(info, name, given, where)
    local values = {}
    for key, property in pairs(info.properties) do values[key] = property.default end
    for key, value in pairs(given or {}) do
      local property = info.properties[key]
      if not property then
        local near = core.nearest(tostring(key), sorted_keys(info.properties))
        core.raise(("%s: behaviours.%s has no property '%s'%s"):format(where, name, tostring(key),
          near and ("; did you mean '%s'?"):format(near) or ""))
      end
      values[key] = fit(property, value, ("%s: behaviours.%s.%s"):format(where, name, key))
    end
    return values
  end

  function behaviours.check(name, given, where)
    local _, info = behaviours.class(name, where)
    fill(info, name, given, where)
  end

  -- ---- instances
  function behaviours.attach(node, name, given, where)
    local class, info = behaviours.class(name, where)
    local instance = { node = node, enabled = true }
    local values = fill(info, name, given, where)
    for key, value in pairs(values) do rawset(instance, key, core.copy(value)) end
    records[instance] = { class = class, info = info, name = name, node = node, initial = values, given = given or {}, alive = true, fresh = true }
    setmetatable(instance, info.instance_meta)
    instances[node] = instances[node] or {}
    instances[node][name] = instance
    fresh[#fresh + 1] = instance
    core.mark(node, true)
    return instance
  end

  function behaviours.detach(node, name)
    local instance = instances[node] and instances[node][name]
    if not instance then return end
    parts.handlers.call(instance, "on_destroy")
    records[instance].alive = false
    instances[node][name] = nil
    parts.tasks.stop_owned(instance)
    core.lists_changed()
  end

  -- After the text changed: fields whose own initial value differs now take it; a field tuned in play stays.
  function behaviours.refresh(changes)
    for _, node in ipairs(core.scripted_nodes()) do
      for _, name in ipairs(sorted_keys(instances[node] or {})) do
        local instance = instances[node][name]
        local record = records[instance]
        local found, class, info = pcall(behaviours.class, name, "reload")
        local ok, values = found, nil
        if found then
          record.class, record.info, record.stopped = class, info, nil
          ok, values = pcall(fill, info, name, record.given, "reload")
        else
          changes[#changes + 1] = ("behaviour %s is gone from the text: its instances keep the old code"):format(name)
        end
        if ok then
          for key in pairs(info.properties) do
            if not core.same(values[key], record.initial[key]) then
              changes[#changes + 1] = ("%s.%s = %s"):format(name, key, core.short(values[key]))
                .. (core.same(rawget(instance, key), record.initial[key]) and "" or (" (was %s in play)"):format(core.short(rawget(instance, key))))
              rawset(instance, key, core.copy(values[key]))
            end
          end
          record.initial = values
        end
      end
    end
  end

  -- A declaration gives this behaviour of the node other properties.
  function behaviours.declare(node, name, given)
    local instance = instances[node] and instances[node][name]
    if not instance then return behaviours.attach(node, name, given, "reload") end
    records[instance].given = given
  end

  -- start() of everything new, parents first by creation; a start() may add more.
  function behaviours.start_new()
    local i = 1
    while i <= #fresh do
      local instance = fresh[i]
      local record = records[instance]
      record.fresh = nil
      if record.alive then
        record.starting = true
        parts.handlers.call(instance, "start")
        record.starting = nil
      end
      i = i + 1
    end
    fresh = {}
    if i > 1 then core.lists_changed() end
  end

  -- scene.restart(): every behaviour of the node starts anew with its first properties.
  function behaviours.restart(node, declared_behaviours)
    for _, name in ipairs(sorted_keys(instances[node] or {})) do
      records[instances[node][name]].alive = false
      parts.tasks.stop_owned(instances[node][name])
      instances[node][name] = nil
    end
    for _, name in ipairs(sorted_keys(declared_behaviours)) do
      behaviours.attach(node, name, declared_behaviours[name], "scene.restart")
    end
  end

  function behaviours.forget(node)
    for _, name in ipairs(sorted_keys(instances[node] or {})) do
      records[instances[node][name]].alive = false
      parts.tasks.stop_owned(instances[node][name])
    end
    instances[node] = nil
  end

  -- Name -> the properties that differ from the class's own, for scene.save.
  function behaviours.saved(node)
    local list = {}
    for name, instance in pairs(instances[node] or {}) do
      local properties = {}
      for key, property in pairs(records[instance].info.properties) do
        local value = rawget(instance, key)
        if not core.same(value, property.default) then properties[key] = value end
      end
      list[name] = properties
    end
    return list
  end

  -- What node.behaviours gives: instances by name, to be read, added and removed.
  function behaviours.view(node)
    return setmetatable({}, {
      __index = function(_, name)
        local instance = instances[node] and instances[node][name]
        if instance then return instance end
        if not files.exists(name) then behaviours.class(name, "node.behaviours") end
        return nil
      end,
      __newindex = function(_, name, given)
        if given == nil then return behaviours.detach(node, name) end
        if instances[node] and instances[node][name] then behaviours.detach(node, name) end
        behaviours.attach(node, name, given, "node.behaviours")
        core.lists_changed()
      end,
      __pairs = function() return pairs(instances[node] or {}) end,
      __metatable = "behaviours",
    })
  end

  return behaviours
end
