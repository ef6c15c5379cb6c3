-- A dotted line in the air, to show where a throw will go: one small glowing ball for each point.
local Arc = behaviour { dots = 18, radius = 0.035 }

function Arc:start()
  for i = 1, self.dots do
    local size = math.lerp(1, 0.4, i / self.dots)         -- the farther, the less certain
    scene.add { parent = self.node, visible = false, mesh = { shape = "sphere", radius = self.radius * size },
      material = { color = "#fff3c4", glow = 1 } }
  end
end

function Arc:show(points)
  for i, dot in ipairs(self.node.children) do
    dot.visible = points[i] ~= nil
    if points[i] then dot.position = points[i] end
  end
end

return Arc
