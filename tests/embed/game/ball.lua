local Ball = behaviour { touched = 0 }
function Ball:on_collision_enter() self.touched = self.touched + 1 end
return Ball
