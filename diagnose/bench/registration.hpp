#pragma once
/// \file
/// The frames of a bench of poses: where the tracker stands, and where the points sit on their links.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The rotations that turn axes into axes, from which a search for a frame starts.
std::vector<Eigen::Matrix3d> turns_of_axes();

/// Tells all places and orientations in another frame; sensors beside the tracker are where they are.
/// \param frame  the present frame of the tracker, in the one in which they were told; that of the arm's world
///               becomes the present one
void move_tracker(Experiment& experiment, const Pose<double>& frame);

/// Moves a point on its link. Orientations stay those that were seen, told from the moved frame.
/// \param by  in the axes of the point
void move_point(Experiment& experiment, std::size_t point, const Pose<double>& by);

/// A place that was seen, and the link that carries the point, where the arm is said to have it.
struct Sight {
  std::size_t point;
  Pose<double> link;
  Vector3<double> place;
};

/// Root mean square distance of places from those of an arm, over that from their mean: the same in any unit.
/// \param points  on their links
double misfit_as_told(const std::vector<Sight>& sights, const std::vector<Vector3<double>>& points);

/// The same with tracker and points where they fit best, from the points on that are given.
double misfit_in_any_frame(const std::vector<Sight>& sights, std::vector<Vector3<double>> points);

/// The world of the arm in the frame of the tracker, with all points where they fit best: by Gauss and
/// Newton's method from the frame in which declared points fit best (Kabsch), and from every orientation that
/// turns axes into axes, geometry nominal and joints at their
/// commands. Places and orientations are told in the world of the arm thereafter. Nothing moves where there
/// are fewer places than unknowns.
/// \returns the frame by which they were moved
Pose<double> register_frames(Experiment& experiment);

}  // namespace plumbline::diagnose
