#include "whittle/engine/threshold_pairs.hh"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "pairs/site_boxes.hh"
#include "pairs/site_tree.hh"
#include "pairs/vertex_sites.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle.hh"

// Each vertex lists its partners, block after block of vertices along the curve. A pair is written where the lower
// vertex lists the higher one. If the lower one's list is full and lacks it, the higher one adds the pair.
//
// Vertices in succession lie close together. A few of them look for nearby sites together; then each measures its
// distance from these. A vertex with very many candidates looks for the nearest in a kd-tree, by itself.

namespace whittle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t leaf_size = 32;      // 16 to 32: equal search times; the tree is built fastest with 32
constexpr std::size_t max_hits = 96;       // of a search in the tree before its reach is shortened
constexpr std::size_t block_length = 512;  // some hundred microseconds of work
constexpr std::size_t group_length = 8;    // members that look for candidates together

/// For each member the other two corners of its faces.
struct Fans {
  std::vector<std::size_t> begins;
  std::vector<Index> others;

  std::span<const Index> of(Index member) const {
    return std::span(others).subspan(begins[member], begins[member + 1] - begins[member]);
  }
};

Fans make_fans(std::span<const Triangle> faces, const VertexSites& sites) {
  Fans fans;
  fans.begins.assign(sites.n_members() + 2, 0);
  const auto for_each_face = [&](const auto& use) {
    for (const Triangle& face : faces) {
      if (has_three_corners(face)) use(sites.members[face[0]], sites.members[face[1]], sites.members[face[2]]);
    }
  };
  // One slot beyond their begins: filling the lists moves each to its begin.
  for_each_face([&](Index a, Index b, Index c) {
    for (const Index corner : {a, b, c}) fans.begins[corner + 2] += 2;
  });
  for (std::size_t i = 2; i < fans.begins.size(); ++i) fans.begins[i] += fans.begins[i - 1];
  fans.others.resize(fans.begins.back());
  for_each_face([&](Index a, Index b, Index c) {
    const auto add = [&](Index corner, Index first, Index second) {
      std::size_t& end = fans.begins[corner + 1];
      fans.others[end++] = first;
      fans.others[end++] = second;
    };
    add(a, b, c);
    add(b, c, a);
    add(c, a, b);
  });
  fans.begins.pop_back();
  return fans;
}

/// For each member the sum of its faces' normals, each as long as twice the area.
std::vector<Vec3> make_normals(std::span<const Triangle> faces, const VertexSites& sites) {
  std::vector<Vec3> normals(sites.n_members(), Vec3::Zero());
  for (const Triangle& face : faces) {
    if (!has_three_corners(face)) continue;
    std::array<Index, 3> corners;
    std::transform(face.begin(), face.end(), corners.begin(), [&](Index v) { return sites.members[v]; });
    const auto point = [&](std::size_t i) -> const Vec3& { return sites.points[sites.sites[corners[i]]]; };
    const Vec3 normal = area_normal(point(0), point(1), point(2));
    for (const Index corner : corners) normals[corner] += normal;
  }
  return normals;
}

/// What the search looks at.
struct Scene {
  Scene(std::span<const Vec3> positions, std::span<const Triangle> faces, const PairSearch& search)
      : sites(make_vertex_sites(positions, faces, search.threads)) {
    const auto build = [&](std::size_t part) {
      if (part == 0) {
        fans = make_fans(faces, sites);
      } else if (!search.across_walls) {
        normals = make_normals(faces, sites);
      }
    };
    for_each_block(2, search.threads, build);
  }

  /// Built when first asked for. Many searches do without.
  const SiteTree& tree() const {
    std::call_once(is_tree_built_,
                   [&] { tree_.emplace(3, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size)); });
    return *tree_;
  }

  double distance_sq(Index site, Index other) const { return (sites.points[site] - sites.points[other]).squaredNorm(); }

  /// Whether the line from one to the other enters the solid and leaves it. To the bit the same in both directions.
  bool is_across_wall(Index member, Index other) const {
    const Vec3 way = sites.points[sites.sites[other]] - sites.points[sites.sites[member]];
    const Vec3& here = normals[member];
    const Vec3& there = normals[other];
    return here.dot(way) < 0 && there.dot(way) > 0 && here.dot(there) < 0;
  }

  VertexSites sites;
  SiteBoxes boxes{sites.points};
  Fans fans;
  std::vector<Vec3> normals;  ///< empty if walls don't matter

 private:
  SiteCloud cloud_{sites.points};
  mutable std::optional<SiteTree> tree_;
  mutable std::once_flag is_tree_built_;
};

struct Partner {
  double distance_sq;
  Index vertex;  ///< its number in the input

  /// By distance; ties by number.
  bool operator<(const Partner& other) const {
    return distance_sq < other.distance_sq || (distance_sq == other.distance_sq && vertex < other.vertex);
  }
};

/// Finds the partners of vertices. Also nanoflann's result set, which is offered sites.
class PartnerSearch {
 public:
  using DistanceType = double;

  /// \param threshold_sq in the frame
  PartnerSearch(const Scene& scene, double threshold_sq, std::size_t max_partners)
      : scene_(scene),
        points_(scene.sites.points.data()),
        threshold_sq_(threshold_sq),
        margin_(Vec3::Constant(std::min(std::sqrt(with_margin(threshold_sq)), 1e9))),
        max_partners_(max_partners),
        excluded_for_(scene.sites.n_members(), invalid_index) {}

  /// Calls `use(member, partners)` for each of the members, in their order. The order of the partners is undefined.
  template <class Use>
  void find(Index begin, Index end, const Use& use) {
    const Index middle = begin + (end - begin) / 2;
    const Box first = box_around(begin, middle);
    const Box second = box_around(middle, end);
    const Box both = first.merged(second);
    const bool are_together = search_size_sq(first) + search_size_sq(second) >= search_size_sq(both);
    const bool has_candidates = are_together && find_candidates(both);
    // Halves search less space where the curve jumps, but hardly less where the threshold exceeds the box.
    if (!has_candidates && middle > begin && both.sizes().norm() > margin_.x()) {
      find(begin, middle, use);
      find(middle, end, use);
      return;
    }
    for (Index member = begin; member < end; ++member) {
      start(member);
      if (has_candidates) {
        measure_candidates();
      } else {
        scene_.tree().findNeighbors(*this, point_.data(), {});
      }
      use(member, finish());
    }
  }

  /// Whether there were more partners than the limit. Then only the nearest are left, up to the furthest of them.
  bool has_more() const { return has_more_; }
  const Partner& furthest() const { return partners_[n_partners_ - 1]; }

  /// Asked for before each leaf: here room is made for all of its points.
  // NOLINTNEXTLINE(readability-identifier-naming): nanoflann's
  double worstDist() {
    if (n_hits_ + leaf_size > max_hits) sift();
    return with_margin(reach_sq_);
  }
  // NOLINTNEXTLINE(readability-identifier-naming): nanoflann's
  bool addPoint(double /*zero*/, Index site) {
    hits_[n_hits_] = site;
    n_hits_ += static_cast<std::size_t>(distance_sq_to(site) < reach_sq_);
    return true;
  }
  static bool full() { return true; }

 private:
  /// Finds all sites within the threshold of what is in the box, and some more. \return whether they are few enough
  bool find_candidates(const Box& box) {
    // Rounding is monotonic, so the larger box misses no site.
    n_candidates_ = scene_.boxes.find({box.min() - margin_, box.max() + margin_}, candidates_);
    if (n_candidates_ > SiteBoxes::limit) return false;
    for (std::size_t i = 0; i < n_candidates_; ++i) set_lane(candidate_points_[i / 2], i % 2, points_[candidates_[i]]);
    if (n_candidates_ % 2 > 0) set_lane(candidate_points_[n_candidates_ / 2], 1, Vec3::Constant(infinity));
    return true;
  }

  Box box_around(Index begin, Index end) const {
    Box box;
    for (Index member = begin; member < end; ++member) box.extend(points_[scene_.sites.sites[member]]);
    return box;
  }

  /// The diagonal, squared, of the box with the candidates; 0 for an empty one.
  double search_size_sq(const Box& box) const { return box.isEmpty() ? 0 : (box.sizes() + 2 * margin_).squaredNorm(); }

  /// Turns the candidates that are near enough into hits.
  void measure_candidates() {
    const PointLanes<double> p = point_lanes(point_);
    const double reach_sq = with_margin(threshold_sq_);
    Index* end = hits_.data();
    for (Index i = 0; i < n_candidates_; i += 2) {
      const PointLanes<Double2>& points = candidate_points_[i / 2];
      const Double2 dx = points.x - p.x;
      const Double2 dy = points.y - p.y;
      const Double2 dz = points.z - p.z;
      end = write_set(dx * dx + dy * dy + dz * dz < reach_sq, i, end);
    }
    n_hits_ = static_cast<std::size_t>(end - hits_.data());
    for (std::size_t i = 0; i < n_hits_; ++i) hits_[i] = candidates_[hits_[i]];
  }

  void start(Index member) {
    member_ = member;
    point_ = points_[scene_.sites.sites[member]];
    reach_sq_ = threshold_sq_;
    n_hits_ = 0;
    n_partners_ = 0;
    has_more_ = false;
    excluded_for_[member] = member;
    for (const Index other : scene_.fans.of(member)) excluded_for_[other] = member;
  }

  std::span<const Partner> finish() {
    sift();
    if (n_partners_ > max_partners_) keep_nearest();
    return {partners_.data(), n_partners_};
  }

  /// Turns hits into partners.
  void sift() {
    const std::span<const Index> hits(hits_.data(), n_hits_);
    make_room(hits.size());
    const VertexSites& sites = scene_.sites;
    for (const Index site : hits) {
      const Index member = sites.begins[site];
      const double distance_sq = distance_sq_to(site);
      if (sites.begins[site + 1] - member > 1) {
        if (distance_sq < reach_sq_) add_members(site, distance_sq);
        make_room(hits.size());
      } else {  // unpredictable, hence branch-free
        partners_[n_partners_] = {distance_sq, sites.vertices[member]};
        n_partners_ += static_cast<std::size_t>(distance_sq < reach_sq_) & static_cast<std::size_t>(is_partner(member));
      }
    }
    n_hits_ = 0;
    // Only at twice the limit, so that it costs no more than finding them.
    if (n_partners_ / 2 >= max_partners_) keep_nearest();
  }

  void add_members(Index site, double distance_sq) {
    const VertexSites& sites = scene_.sites;
    // Members of a site ascend by number: only the first ones up to the limit can be among the nearest.
    const std::size_t enough = n_partners_ + max_partners_ + 1;
    for (Index member = sites.begins[site]; member < sites.begins[site + 1] && n_partners_ < enough; ++member) {
      if (!is_partner(member)) continue;
      make_room(1);
      partners_[n_partners_++] = {distance_sq, sites.vertices[member]};
    }
  }

  bool is_partner(Index member) const {
    bool result = excluded_for_[member] != member_;
    if (!scene_.normals.empty()) result = result && !scene_.is_across_wall(member_, member);
    return result;
  }

  double distance_sq_to(Index site) const { return (point_ - points_[site]).squaredNorm(); }

  void make_room(std::size_t n_more) {
    if (partners_.size() < n_partners_ + n_more) partners_.resize(2 * (n_partners_ + n_more));
  }

  void keep_nearest() {
    has_more_ = true;
    std::nth_element(partners_.data(), partners_.data() + (max_partners_ - 1), partners_.data() + n_partners_);
    n_partners_ = max_partners_;
    // A member as far away as the furthest may have a lower number.
    reach_sq_ = std::min(reach_sq_, std::nextafter(furthest().distance_sq, infinity));
  }

  const Scene& scene_;
  const Vec3* points_;
  double threshold_sq_;
  Vec3 margin_;  ///< finite, even for an infinite threshold: then larger than the mesh
  std::size_t max_partners_;
  std::vector<Index> excluded_for_;  ///< per member: the one last searched for that it is, or shares a face with

  Index member_ = invalid_index;
  Vec3 point_;
  double reach_sq_ = 0;  ///< squared distance; whatever is nearer may be a partner

  SiteBoxes::Sites candidates_;
  std::size_t n_candidates_ = 0;
  std::array<PointLanes<Double2>, SiteBoxes::limit / 2> candidate_points_;
  std::array<Index, SiteBoxes::limit + leaf_size> hits_;  ///< sites
  static_assert(max_hits <= SiteBoxes::limit + leaf_size);
  std::size_t n_hits_ = 0;
  std::vector<Partner> partners_;  ///< with room for more
  std::size_t n_partners_ = 0;
  bool has_more_ = false;
};

/// The partners that `block_length` members in succession have listed by themselves.
struct Block {
  struct List {
    std::size_t begin;  ///< in `partners`: first the higher numbers, ascending, then the lower
    Index n_higher;
    Index n_lower;
  };
  std::vector<Index> partners;    ///< by their numbers in the input
  std::vector<List> lists;        ///< of each member
  std::vector<Partner> furthest;  ///< the last of each list that was cut, else infinitely far; empty if none was

  std::span<const Index> higher(const List& list) const {
    return std::span(partners).subspan(list.begin, list.n_higher);
  }
  std::span<const Index> lower(const List& list) const {
    return std::span(partners).subspan(list.begin + list.n_higher, list.n_lower);
  }

  void add_list(Index vertex, std::span<const Partner> list) {
    const std::size_t begin = partners.size();
    partners.resize(begin + list.size());
    // From both ends. Unpredictable, hence branch-free.
    std::size_t middle = begin;
    std::size_t last = partners.size();
    for (const Partner& partner : list) {
      const bool is_higher = partner.vertex > vertex;
      last -= static_cast<std::size_t>(!is_higher);
      partners[is_higher ? middle : last] = partner.vertex;
      middle += static_cast<std::size_t>(is_higher);
    }
    std::sort(partners.data() + begin, partners.data() + middle);
    lists.push_back({begin, static_cast<Index>(middle - begin), static_cast<Index>(partners.size() - middle)});
  }

  void set_furthest(const Partner& partner) {
    if (furthest.empty()) furthest.assign(block_length, {infinity, invalid_index});
    furthest[lists.size() - 1] = partner;
  }
};

/// The partners of all members.
class PartnerLists {
 public:
  PartnerLists(const Scene& scene, double threshold_sq, std::size_t max_partners, const detail::Workers& workers)
      : blocks_((scene.sites.n_members() + block_length - 1) / block_length) {
    std::atomic<std::size_t> next_block{0};
    const auto search_blocks = [&](std::size_t /*thread*/) {
      PartnerSearch search(scene, threshold_sq, max_partners);
      for (std::size_t i = next_block++; i < blocks_.size(); i = next_block++) {
        workers.update(static_cast<double>(i) / static_cast<double>(blocks_.size()));
        blocks_[i] = search_block(search, scene, i);
      }
    };
    for_each_block(std::min(n_threads(workers.threads), blocks_.size()), workers.threads, search_blocks);
  }

  std::size_t n_blocks() const { return blocks_.size(); }
  const Block& block(std::size_t i) const { return blocks_[i]; }

  std::span<const Index> higher(Index member) const {
    const Block& block = blocks_[member / block_length];
    return block.higher(block.lists[member % block_length]);
  }
  /// Whether some list was cut.
  bool is_cut() const {
    return std::any_of(blocks_.begin(), blocks_.end(), [](const Block& block) { return !block.furthest.empty(); });
  }
  /// Whether the member's own list lacks `partner`, which lists the member.
  bool is_cut_off(Index member, const Partner& partner) const {
    const Block& block = blocks_[member / block_length];
    return !block.furthest.empty() && block.furthest[member % block_length] < partner;
  }

 private:
  static Block search_block(PartnerSearch& search, const Scene& scene, std::size_t i) {
    Block block;  // local, so that threads don't write to one cache line
    const std::size_t end = std::min(scene.sites.n_members(), (i + 1) * block_length);
    block.lists.reserve(block_length);
    const auto add = [&](Index member, std::span<const Partner> partners) {
      block.add_list(scene.sites.vertices[member], partners);
      if (search.has_more()) block.set_furthest(search.furthest());
    };
    for (std::size_t begin = i * block_length; begin < end; begin += group_length)
      search.find(static_cast<Index>(begin), static_cast<Index>(std::min(end, begin + group_length)), add);
    return block;
  }

  std::vector<Block> blocks_;
};

/// The pairs that only the higher vertex lists, a vector for each block of these.
std::vector<std::vector<VertexPair>> find_one_sided_pairs(const Scene& scene, const PartnerLists& partners,
                                                          unsigned threads) {
  const VertexSites& sites = scene.sites;
  std::vector<std::vector<VertexPair>> result(partners.n_blocks());
  for_each_block(result.size(), threads, [&](std::size_t i) {
    const Block& block = partners.block(i);
    std::vector<VertexPair> pairs;
    auto member = static_cast<Index>(i * block_length);
    for (const Block::List& list : block.lists) {
      for (const Index lower : block.lower(list)) {
        const Index other = sites.members[lower];
        const Partner partner{scene.distance_sq(sites.sites[other], sites.sites[member]), sites.vertices[member]};
        if (partners.is_cut_off(other, partner)) pairs.push_back({lower, partner.vertex});
      }
      ++member;
    }
    result[i] = std::move(pairs);
  });
  return result;
}

std::vector<VertexPair> write_pairs(const Scene& scene, const PartnerLists& partners, unsigned threads) {
  std::vector<std::vector<VertexPair>> one_sided;
  if (partners.is_cut()) one_sided = find_one_sided_pairs(scene, partners, threads);

  const std::vector<Index>& members = scene.sites.members;
  std::vector<std::size_t> ends(members.size() + 1, 0);
  for (std::size_t v = 0; v < members.size(); ++v) {
    if (members[v] != invalid_index) ends[v + 1] = partners.higher(members[v]).size();
  }
  for (const auto& block : one_sided) {
    for (const VertexPair& pair : block) ++ends[pair.a + 1];
  }
  for (std::size_t v = 0; v < members.size(); ++v) ends[v + 1] += ends[v];

  // ends[v] is where the pairs of v begin, and moves on as they are written.
  std::vector<VertexPair> pairs(ends.back());
  for_each_range(members.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      if (members[v] == invalid_index) continue;
      for (const Index partner : partners.higher(members[v])) pairs[ends[v]++] = {v, partner};
    }
  });
  if (one_sided.empty()) return pairs;
  for (const auto& block : one_sided) {
    for (const VertexPair& pair : block) pairs[ends[pair.a]++] = pair;
  }
  ends.pop_back();
  for_each_range(ends.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const auto at = [&](std::size_t i) { return pairs.begin() + static_cast<std::ptrdiff_t>(i); };
      std::sort(at(v == 0 ? 0 : ends[v - 1]), at(ends[v]));
    }
  });
  return pairs;
}

}  // namespace

ThresholdPairs find_threshold_pairs(std::span<const Vec3> positions, std::span<const Triangle> faces,
                                    const PairSearch& search) {
  if (!(search.threshold >= 0)) {
    throw std::invalid_argument("find_threshold_pairs: the threshold is negative or not a number");
  }
  if (search.max_pairs == 0) throw std::invalid_argument("find_threshold_pairs: max_pairs is 0; empty takes all");
  if (search.threshold == 0) return {};
  detail::ProgressMeter meter(search.progress);
  meter.start("preparing the search for threshold pairs", 0.2);
  const Scene scene(positions, faces, search);
  const std::size_t n_members = scene.sites.n_members();
  if (n_members == 0) return {};
  const double threshold = search.threshold * scene.sites.frame.scale;
  // The square of a tiny threshold may round to zero: use at least what tells coincident vertices from others.
  const double threshold_sq = std::max(threshold * threshold, std::numeric_limits<double>::denorm_min());
  const std::size_t max_partners = std::min<std::size_t>(search.max_pairs.value_or(invalid_index), n_members);
  meter.start("searching threshold pairs", 1);
  const PartnerLists partners(scene, threshold_sq, max_partners, detail::Workers(search.threads, &meter));
  return {write_pairs(scene, partners, search.threads), partners.is_cut()};
}

}  // namespace whittle
