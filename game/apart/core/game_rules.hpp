// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/game_state.hpp>
#include <apart/core/input.hpp>

#include <cstddef>

namespace apart {

// Rules of a Game, by the file that has them. Each changes the state of one tick.

// game_scene.cpp: initial scene, and the motion of the boss.
void buildScene(GameState& game);
void driveBoss(GameState& game);

// game_paddle.cpp: paddle, serve, and the parts that stick to the paddle.
void newPaddle(GameState& game);
void newServe(GameState& game);
/// Turns the next serve to x/y in 1/1000, kMostAim at most.
void aimServe(GameState& game, std::int16_t aim);
void serve(GameState& game);
void leap(GameState& game);
void steer(GameState& game, const Input& input);
void fireParts(GameState& game);
void letGoOfParts(GameState& game);
/// Sets the velocity and adds the gained kinetic energy (J) to `work`.
void drive(kodo::BodyRef body, kodo::Vec2 velocity, double& work);

// game_forces.cpp: force field and magnet of the paddle.
void useForce(GameState& game, const Input& input);
void applyForces(GameState& game);

// game_judge.cpp: collisions of the tick.
void judge(GameState& game);

// game_blocks.cpp: blocks that lose their support, and the time without damage.
void judgeBoss(GameState& game);
/// Gives the block its own body.
kodo::BodyId detach(GameState& game, std::size_t index);
void letGo(GameState& game, std::size_t index, LetGo::Why why);
void watchProgress(GameState& game);
void removeGoneBlocks(GameState& game);

// game_collapse.cpp: buildings.
void watchBuildings(GameState& game);
/// Removes the links of joints that are no longer in the world.
void forgetLinks(GameState& game);
void markFallen(GameState& game, std::size_t index, LetGo::Why why);
/// Counts a standing block that fell or broke. Returns its points.
std::int32_t addToCollapse(GameState& game, const Block& block);
/// Scores the points of a fallen block.
void land(GameState& game, Block& block, const kodo::CollisionRecord* impact = nullptr);
void endCollapse(GameState& game);

// game_water.cpp: water, which floats blocks and runs out through broken dams.
void fillWaters(GameState& game);
void watchWaters(GameState& game);
void addWaterFields(const GameState& game, std::vector<kodo::FieldEntry>& fields);

// game_pieces.cpp: pieces of broken blocks, and bodies that left the field or expired.
void breakBlock(GameState& game, std::size_t index, kodo::Vec2 point, kodo::Vec2 impact);
void breakShard(GameState& game, std::size_t index, kodo::Vec2 point, kodo::Real impulse);
void removeGone(GameState& game);

// game_powers.cpp: timed powers.
void beginPower(GameState& game, Power power, kodo::Vec2 point, kodo::Vec2 origin);
void endPower(GameState& game, std::size_t effect);
void endOldPowers(GameState& game);
void refreshPowers(GameState& game);
void renewFields(GameState& game);
bool weldWings(GameState& game);

// game_govern.cpp: speed and direction of the balls.
void govern(GameState& game);

} // namespace apart
