#include <fmt/format.h>
#include <fmt/ranges.h>

#include "diagnose/exchange/corrected_arm.hpp"

namespace plumbline::exchange {
namespace {

/// A list of lists, as numpy takes it, with all digits.
template <class Matrix>
std::string rows(const Matrix& matrix) {
  std::vector<std::string> lines;
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
    std::vector<double> row;
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) row.push_back(matrix(r, c));
    lines.push_back(fmt::format("[{}]", fmt::join(row, ", ")));
  }
  return fmt::format("[{}]", fmt::join(lines, ", "));
}

std::string row(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

std::string link_text(const ArmLink<double>& link) {
  return fmt::format("    ({}, {}, {}, {}, {}, {}, {}),\n",
                     link.kind == JointKind::prismatic ? "True" : "False", rows(link.frame.matrix()),
                     row(link.axis), link.joint_compliance, link.mass, row(link.centre),
                     link.compliance.isZero(0) ? "None" : rows(link.compliance));
}

constexpr const char* mechanics = R"py(

def turn(axis, angle):
    """The rotation about a unit vector."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def moved(frame, slides, axis, by):
    motion = np.eye(4)
    if slides:
        motion[:3, 3] = by * np.asarray(axis)
    else:
        motion[:3, :3] = turn(axis, by)
    return frame @ motion


def posture(coordinates):
    """The freedoms (slides, axis, origin), the weights by the number of freedoms that move them, the tip's pose."""
    freedoms, weights, at, rest = [], [], np.array(BASE), list(coordinates)
    for i, (slides, frame, axis, _, mass, centre, compliance) in enumerate(LINKS):
        at = at @ np.array(frame)
        freedoms.append((slides, at[:3, :3] @ axis, at[:3, 3]))
        at = moved(at, slides, axis, rest.pop(0))
        weights.append((len(freedoms), mass, (at @ [*centre, 1])[:3]))
        if compliance is None:
            continue
        far = np.array(LINKS[i + 1][1] if i + 1 < len(LINKS) else TIP)[:3, 3]
        there, back = np.eye(4), np.eye(4)
        there[:3, 3], back[:3, 3] = far, -far
        at = at @ there
        for slides_, axis_ in [(True, e) for e in np.eye(3)] + [(False, e) for e in np.eye(3)]:
            freedoms.append((slides_, at[:3, :3] @ axis_, at[:3, 3]))
            at = moved(at, slides_, axis_, rest.pop(0))
        at = at @ back
    tip = at @ np.array(TIP)
    weights.append((len(freedoms), PAYLOAD[0], (tip @ [*PAYLOAD[1], 1])[:3]))
    return freedoms, weights, tip


def loads(coordinates, force, moment):
    """Generalised forces on all freedoms."""
    freedoms, weights, tip = posture(coordinates)
    result = []
    for k, (slides, axis, origin) in enumerate(freedoms):
        acting = [(mass * np.array(GRAVITY), place) for movers, mass, place in weights if movers > k]
        acting.append((np.asarray(force, float), tip[:3, 3]))
        if slides:
            result.append(sum(axis @ f for f, _ in acting))
        else:
            result.append(sum(axis @ np.cross(place - origin, f) for f, place in acting) + axis @ np.asarray(moment, float))
    return np.array(result)


def tip_pose(command, force=(0, 0, 0), moment=(0, 0, 0)):
    """The pose of the tip in the world, 4 x 4, at these joint commands (rad, m), under gravity and a wrench at the tip (N, N m)."""
    start, blocks = [], []
    for q, (*_, soft, _, _, compliance) in zip(command, LINKS, strict=True):
        start += [q] + ([] if compliance is None else [0.0] * 6)
        blocks += [np.array([[soft]])] + ([] if compliance is None else [np.array(compliance)])
    soft, next_ = np.zeros((len(start), len(start))), 0
    for block in blocks:
        soft[next_:next_ + len(block), next_:next_ + len(block)] = block
        next_ += len(block)
    at = np.array(start, float)
    for _ in range(500):
        after = np.array(start) + soft @ loads(at, force, moment)
        step, at = np.abs(after - at).max(), after
        if step < 1e-14 * (1 + np.abs(at).max()):
            return posture(at)[2]
    raise ValueError(f"command: found no rest near it, the last step was {step:g}, expected springs that are stiffer than the loads")
)py";

}  // namespace

Written as_python(const CorrectedArm& corrected) {
  const SerialArm<double>& arm = corrected.arm;
  std::string text = "\"\"\"" + corrected.title + "\n";
  for (const Carried& one : corrected.others)
    text += fmt::format("{}{}: {}\n", one.carried ? "" : "NOT CARRIED: ", one.effect, one.how);
  text += "\"\"\"\nimport numpy as np\n\n";
  text += fmt::format("BASE = {}  # in the world\nGRAVITY = {}  # in the world, m/s^2\n",
                      rows(arm.base.matrix()), row(arm.gravity));
  text +=
      "# slides, frame in that of the link before, axis, compliance of the joint, mass, centre, compliance "
      "of the link\n";
  text += "LINKS = [\n";
  for (const ArmLink<double>& link : arm.links) text += link_text(link);
  text += fmt::format("]\nTIP = {}  # in the last link\nPAYLOAD = ({}, {})  # kg; in the frame of the tip\n",
                      rows(arm.tip.matrix()), corrected.payload.mass, row(corrected.payload.centre));
  return {text + mechanics, {}, "a function in Python"};
}

}  // namespace plumbline::exchange
