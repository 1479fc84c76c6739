#pragma once

#include "adaptivity/singular/Transitions.hpp"
#include "bem/base/Processes.hpp"

namespace epafi::adaptivity {

/// Where a node goes on its edge.
struct Move {
  int node = 0;
  bem::Position to;
};

/// Which nodes stay whatever happens: those that `coarse`, the scene's own mesh, has. Its
/// nodes are the outline's vertices and the places where the user's functions may bend.
std::vector<bool> heldNodes(const bem::Mesh& mesh, const bem::Mesh& coarse);

/// The nodes that follow the transitions: to each goes at most one, which lies off it by
/// at most `reach` times the length of the element that the transition is in.
///
/// Of several it is the one with the smallest neighbours: the middle of an earlier
/// transition's layers.  Nodes do not overtake each other, and the elements between two
/// that are held or move become at most four times longer or shorter: what does not fit
/// is left out.  Nodes closer than a percent of the shorter neighbour are there already.
std::vector<Move> chooseMoves(const bem::Mesh& mesh, const std::vector<bool>& held,
                              const std::vector<Transition>& transitions, double reach);

/// The moves of rank 0; all processes must call.
std::vector<Move> agree(const std::vector<Move>& moves, const bem::Processes& processes);

/// The mesh with some nodes moved.  Between two that are held or move, all sizes change
/// in proportion, so that geometric layers go along and stay geometric.
bem::Mesh moveNodes(const bem::Mesh& mesh, const std::vector<bool>& held,
                    const std::vector<Move>& moves);

}  // namespace epafi::adaptivity
