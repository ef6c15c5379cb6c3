-- The levels in their order.
return {
  { scene = "levels/one", name = "Meadow Isles", music = "sounds/meadow.ogg", par = 120 },     -- s; each second less is worth 5 points
  { scene = "levels/two", name = "Lantern Dusk", music = "sounds/dusk.ogg", par = 150 },
}
