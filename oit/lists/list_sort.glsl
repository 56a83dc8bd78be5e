// SPDX-License-Identifier: GPL-3.0-or-later
// Sorting the list of one pixel by depth: runs of 16 nodes in registers, merged in place.
#include "oit/lists/fragment_list.glsl"

#define SLOTS_0_TO_7(X) X(0) X(1) X(2) X(3) X(4) X(5) X(6) X(7)
#define SLOTS_8_TO_15(X) X(8) X(9) X(10) X(11) X(12) X(13) X(14) X(15)
#define SLOTS(X) SLOTS_0_TO_7(X) SLOTS_8_TO_15(X)
#define REPEAT8(X) X X X X X X X X

const int RUN = 16;

// A node in registers.
struct Node {
  uint id;   // 0: none
  uint next;
  uvec2 key;  // bits of d, order of submission
};

const Node no_node = Node(0u, 0u, uvec2(~0u));

Node load_node(uint id) {
  uvec4 texel = imageLoad(nodes, int(id));
  return Node(id, texel.x, texel.yz);
}

#if defined(OPTIMIZE_FRAGMENTS) || defined(OPTIMIZE_OPACITY)
uint importance_bits(uint id) { return imageLoad(nodes, int(id)).w; }
#else
uint importance_bits(uint id) { return 0u; }
#endif

void link(Node node, uint next) {
  imageStore(nodes, int(node.id), uvec4(next, node.key, importance_bits(node.id)));
}

// Nearer first; equal depths in the order of submission. Bits of floats >= 0 compare as they do.
bool before(Node a, Node b) {
  return a.key.x < b.key.x || (a.key.x == b.key.x && a.key.y < b.key.y);
}

int count(uint list) {
  int n = 0;
  while (list != 0u) {
    REPEAT8(if (list != 0u) { list = load_node(list).next; ++n; })
  }
  return n;
}

// A list that grows at its end.
struct Chain {
  uint first;
  Node last;
};

const Chain empty_chain = Chain(0u, no_node);

void append(inout Chain chain, Node node) {
  if (chain.first == 0u) chain.first = node.id;
  else link(chain.last, node.id);
  chain.last = node;
}

// A sorted run. Every index is a constant, so that it lives in registers: on llvmpipe a local array
// that is indexed by a variable costs more than the whole sort.
Node run[RUN];

// Inserts a node into a run that will hold `most` nodes, 8 or 16.
void insert_into_run(Node node, int most) {
#define INSERT(i)                           \
  {                                         \
    Node old = run[i];                      \
    bool nearer = before(node, old);        \
    run[i].id = nearer ? node.id : old.id;  \
    run[i].key = nearer ? node.key : old.key; \
    node.id = nearer ? old.id : node.id;    \
    node.key = nearer ? old.key : node.key; \
  }
  SLOTS_0_TO_7(INSERT)
  if (most <= 8) return;
  SLOTS_8_TO_15(INSERT)
}

// The nearest node of the run, which is taken out; id 0 when the run is empty.
Node take_from_run() {
  Node node = run[0];
#define SHIFT(i) run[i] = i < RUN - 1 ? run[min(i + 1, RUN - 1)] : no_node;
  SLOTS(SHIFT)
  return node;
}

void fill_run(inout uint list, inout int n, int most) {
  for (; n < most && list != 0u; ++n) {
    Node node = load_node(list);
    list = node.next;
    insert_into_run(node, most);
  }
}

// Moves up to RUN nodes from the list into the run. Returns how many. Few pixels have more than 8
// layers: the first 8 nodes pass by half of the slots only.
int fill_run(inout uint list) {
#define CLEAR(i) run[i] = no_node;
  SLOTS(CLEAR)
  int n = 0;
  fill_run(list, n, 8);
  fill_run(list, n, RUN);
  return n;
}

void append_run(inout Chain chain) {
  for (Node node = take_from_run(); node.id != 0u; node = take_from_run()) append(chain, node);
}

// Merges neighbouring runs of `length` nodes throughout a list.
//
// llvmpipe silently ends the loops of a shader after 65535 iterations in all. One loop of equal
// small steps, at most two for each node and eight to an iteration, makes the most of them.
struct Merge {
  int length;
  Node p, q;        // fronts of the two runs
  int left, right;  // nodes of them that are still to be taken
  bool splitting;   // q is on its way from the start of the first run to its end
  Chain merged;
};

bool unfinished(Merge m) { return m.splitting || m.left > 0 || m.q.id != 0u; }

void take_nearer(inout Merge m) {
  bool from_right =
      m.left == 0 || (m.right > 0 && m.q.id != 0u && before(m.q, m.p));
  append(m.merged, from_right ? m.q : m.p);
  Node next = load_node(m.merged.last.next);
  if (from_right) {
    m.q = next;
    --m.right;
  } else {
    m.p = next;
    --m.left;
  }
}

void merge_step(inout Merge m) {
  if (m.splitting) {
    m.q = load_node(m.q.next);
    ++m.left;
    m.splitting = m.left < m.length && m.q.id != 0u;
  } else if (m.left > 0 || (m.right > 0 && m.q.id != 0u)) {
    take_nearer(m);
  } else if (m.q.id != 0u) {
    m.p = m.q;
    m.right = m.length;
    m.splitting = true;
  }
}

uint merge_runs(uint list, int length) {
  Node front = load_node(list);
  Merge m = Merge(length, front, front, 0, length, true, empty_chain);
  while (unfinished(m)) {
    REPEAT8(merge_step(m);)
  }
  link(m.merged.last, 0u);
  return m.merged.first;
}
