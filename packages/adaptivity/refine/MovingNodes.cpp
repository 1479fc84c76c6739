#include "adaptivity/refine/MovingNodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::adaptivity {

namespace {

using bem::Position;

double startOf(const bem::Mesh& mesh, int node) {
  return mesh[node].piece.start.fromStart;  // a node has the number of its element
}

double length(const bem::Element& element) { return 2 * element.half; }

/// The sum of the lengths of a node's neighbours.
double neighbourhood(const bem::Mesh& mesh, int node) {
  return length(mesh[node]) + length(mesh[mesh[node].previous]);
}

double smallerNeighbour(const bem::Mesh& mesh, int node) {
  return std::min(length(mesh[node]), length(mesh[mesh[node].previous]));
}

/// The element with this place, or -1.
int elementAt(const bem::Mesh& mesh, const Transition& transition) {
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Piece& piece = mesh[e].piece;
    if (piece.edge == transition.edge && piece.start.fromStart <= transition.place &&
        transition.place < piece.end.fromStart)
      return e;
  }
  return -1;
}

/// Where the nodes come to lie: see moveNodes.
std::vector<Position> movedNodes(const bem::Mesh& mesh, std::vector<bool> fixed,
                                 const std::vector<Move>& moves) {
  const int n = mesh.size();
  std::vector<Position> nodes;
  for (const bem::Element& element : mesh.elements())
    nodes.push_back(element.piece.start);
  for (const Move& move : moves) {
    nodes[move.node] = move.to;
    fixed[move.node] = true;
  }
  // from one fixed node to the next, or to the edge's end
  for (int first = 0; first < n;) {
    const int edge = mesh[first].piece.edge;
    int next = first + 1;
    while (next < n && mesh[next].piece.edge == edge && !fixed[next])
      ++next;
    const Position a = mesh[first].piece.start;
    const Position b = mesh[next - 1].piece.end;
    const bool ends = next == n || mesh[next].piece.edge != edge;
    const Position toA = nodes[first];
    const Position toB = ends ? b : nodes[next];
    const bool moved = toA.fromStart != a.fromStart || toB.fromStart != b.fromStart;
    const double factor = distanceAlong(toA, toB) / distanceAlong(a, b);
    for (int node = first + 1; moved && node < next; ++node) {
      const Position old = mesh[node].piece.start;
      nodes[node] = {toA.fromStart + factor * (old.fromStart - a.fromStart),
                     toB.toEnd + factor * (old.toEnd - b.toEnd)};
    }
    first = next;
  }
  return nodes;
}

std::vector<bem::Piece> movedPieces(const bem::Mesh& mesh, const std::vector<bool>& held,
                                    const std::vector<Move>& moves) {
  const std::vector<Position> nodes = movedNodes(mesh, held, moves);
  std::vector<bem::Piece> pieces;
  for (int e = 0; e < mesh.size(); ++e) {
    bem::Piece piece = mesh[e].piece;
    piece.start = nodes[e];
    if (mesh[mesh[e].next].piece.edge == piece.edge && mesh[e].next == e + 1)
      piece.end = nodes[static_cast<std::size_t>(e) + 1];
    pieces.push_back(piece);
  }
  return pieces;
}

/// Does no element change its length too much?
bool fits(const bem::Mesh& mesh, const std::vector<bool>& held,
          const std::vector<Move>& moves) {
  constexpr double most = 4;
  const std::vector<bem::Piece> pieces = movedPieces(mesh, held, moves);
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Piece& piece = pieces[e];
    const double factor = distanceAlong(piece.start, piece.end) / length(mesh[e]);
    if (!(factor > 1 / most && factor < most))
      return false;
  }
  return true;
}

}  // namespace

std::vector<bool> heldNodes(const bem::Mesh& mesh, const bem::Mesh& coarse) {
  constexpr double tolerance = 1e-12;
  std::vector<bool> held(mesh.size());
  for (int node = 0; node < mesh.size(); ++node) {
    const bem::Piece& piece = mesh[node].piece;
    held[node] = std::any_of(
        coarse.elements().begin(), coarse.elements().end(), [&](const bem::Element& e) {
          return e.piece.edge == piece.edge &&
                 std::abs(distanceAlong(e.piece.start, piece.start)) <=
                     tolerance * std::min(piece.start.fromStart, piece.start.toEnd);
        });
  }
  return held;
}

std::vector<Move> chooseMoves(const bem::Mesh& mesh, const std::vector<bool>& held,
                              const std::vector<Transition>& transitions, double reach) {
  constexpr double there = 0.01;
  std::vector<Move> moves;
  for (const Transition& transition : transitions) {
    const int e = elementAt(mesh, transition);
    if (e < 0)
      continue;
    const double radius = reach * length(mesh[e]);
    int best = -1;
    double size = std::numeric_limits<double>::infinity();
    for (int node = 0; node < mesh.size(); ++node) {
      const bool free = mesh[node].piece.edge == transition.edge && !held[node];
      if (!free || std::abs(startOf(mesh, node) - transition.place) > radius)
        continue;
      if (neighbourhood(mesh, node) < size) {
        best = node;
        size = neighbourhood(mesh, node);
      }
    }
    if (best < 0)
      continue;
    const Position old = mesh[best].piece.start;
    const double way = transition.place - old.fromStart;
    std::vector<Move> more = moves;
    more.push_back({best, {transition.place, old.toEnd - way}});
    const bool taken = std::any_of(moves.begin(), moves.end(),
                                   [&](const Move& m) { return m.node == best; });
    if (!taken && std::abs(way) > there * smallerNeighbour(mesh, best) &&
        fits(mesh, held, more))
      moves = std::move(more);
  }
  return moves;
}

std::vector<Move> agree(const std::vector<Move>& moves, const bem::Processes& processes) {
  bem::Vector numbers;
  for (const Move& move : moves)
    numbers.insert(numbers.end(),
                   {static_cast<double>(move.node), move.to.fromStart, move.to.toEnd});
  numbers = processes.broadcast(std::move(numbers));
  std::vector<Move> agreed;
  for (std::size_t k = 0; k < numbers.size(); k += 3)
    agreed.push_back({static_cast<int>(numbers[k]), {numbers[k + 1], numbers[k + 2]}});
  return agreed;
}

bem::Mesh moveNodes(const bem::Mesh& mesh, const std::vector<bool>& held,
                    const std::vector<Move>& moves) {
  return {mesh.sharedOutline(), movedPieces(mesh, held, moves)};
}

}  // namespace epafi::adaptivity
