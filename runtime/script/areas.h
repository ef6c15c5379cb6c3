// Who fills which area of the table; areas.cpp lists them in the order of the documents.
#pragma once

#include "script/bind.h"

namespace tumble {

void rows_vec3(Area&);
void rows_quat(Area&);
void rows_color(Area&);
void rows_scene(Area&);
void rows_node(Area&);
void rows_children(Area&);
void rows_mesh(Area&);
void rows_material(Area&);
void rows_light(Area&);
void rows_sky(Area&);
void rows_sound_module(Area&);
void rows_sound(Area&);        // the component, node.sound
void rows_voice(Area&);
void rows_sound_groups(Area&);
void rows_particles(Area&);
void rows_animation(Area&);
void rows_camera(Area&);
void rows_body(Area&);
void rows_physics(Area&);
void rows_physics_settings(Area&);  // part of the same
void rows_hit(Area&);
void rows_filter(Area&);
void rows_joint_module(Area&);
void rows_joint(Area&);
void rows_view(Area&);
void rows_input(Area&);
void rows_pointer(Area&);
void rows_time(Area&);
void rows_random(Area&);
void rows_draw(Area&);
void rows_ui(Area&);
const std::vector<const Type*>& ui_option_types();   // for the documents
void rows_storage(Area&);
void rows_log(Area&);
void rows_game(Area&);
void rows_games(Area&);        // game.list, game.open
void rows_task(Area&);
void rows_property_module(Area&);
void rows_property(Area&);

}  // namespace tumble
