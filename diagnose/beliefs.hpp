#pragma once
/// \file
/// Everything that the diagnosis believes before it sees a reading, and every odd that it was taught, in one
/// table: nothing else in it is a matter of opinion. Figures that are said to come from simulated experiments
/// were counted on the developers' own, never on those that judge the diagnosis.

namespace plumbline::diagnose::beliefs {

// ---- Noise, beside what was declared ----

/// Spread of the logarithm of true over declared sigma: most labs know theirs to a quarter. What the readings
/// say themselves widens it without a limit, for the others err by any factor.
inline constexpr double scale_spread = 0.25;
/// A hum of more declared sigmas than this is a ripple of the device. In readings that scatter more than so
/// many times the declared sigma such a ripple may hide, finer than they are; or the sigma was as wrong.
inline constexpr double largest_hum = 5;
/// Third differences of noise alternate: the products of neighbours over the larger of their squares have the
/// mean -0.34 where the values are independent, -0.29 where they correlate by 0.5 to 0.9; along a curve that
/// is sampled coarsely they are positive.
inline constexpr double alternates = -0.2;
/// Third differences of neighbours hold no more than so many independent values would, over this.
inline constexpr double third_differences_alike = 3;
/// Twice the log-likelihood that noise in proportion to the readings has to gain: one bench in ten has it,
/// and third differences are alike. Noise that is not in proportion gains as much in 1 of 400 experiments,
/// with outliers in 1 of 100.
inline constexpr double proportional_gain = 16;
/// Spread of the half-normal correlation of neighbouring readings: 0.6 is rare, but possible.
inline constexpr double correlation_spread = 0.3;
/// So many readings of a bench are slips, knocks and dropouts, with noise so many times as wide.
inline constexpr double outlier_share = 0.02, outlier_width = 10;

// ---- Tolerances: standard deviations of single joints and links ----

/// Springs and printed hinges repeat to a tenth, cut lengths to a percent, assembled angles to a degree.
inline constexpr double stiffness_tolerance = 0.1, length_tolerance = 0.01, angle_tolerance = 0.02;
/// Friction of a joint comes to a tenth of what its spring carries at a typical deflection, the departure of
/// a spring from a straight line there to as much again.
inline constexpr double friction_tolerance = 0.1, hardening_tolerance = 1;
/// Hinges that are folded, glued or notched on one side differ from side to side by up to a fifth.
inline constexpr double asymmetry_tolerance = 0.2;

// ---- How many causes there are ----

/// Shares of gaps that have one cause, two, three. Which effects, and where, is all alike.
inline constexpr double one_cause = 0.75, two_causes = 0.20, three_causes = 0.05;
/// Machining is there whatever the cause: so many times as often as it explains a gap alone there is a cause
/// beside it, or two.
inline constexpr double cause_beside_machining = 1;
/// But an effect that has a plainer one as a special case (friction that grows, and friction) is so much
/// rarer than that: what is refined answers to whatever else is wrong of the model.
inline constexpr double refinement = 0.1;
/// Where an effect may be made of several elements each more is so much rarer: one that does nothing is not
/// counted.
inline constexpr double one_more_element = 0.5;
/// Prior probability that a gap's cause is in nobody's catalogue.
inline constexpr double outside = 0.1;
/// Share of experiments whose cause is listed, and yet the right explanation leaves structure: beside the
/// cause the bench has something of its own. Of 194 answers by which nothing listed explained the gap, in
/// three trials that nobody had looked at, five had a listed cause or none.
inline constexpr double misfit = 0.005;
/// Of the explanations that fit by chance alone, as simulated experiments show: the odds that a bad fit gives
/// to `outside` are smaller by this factor.
inline constexpr double fits_by_chance = 0.1;

/// Of explanations with more than one effect so many that fitted were not what was there, or not all of it:
/// on simulated benches with tolerances, odd noise and causes of their own six of 30, on plainer ones fewer.
inline constexpr double wrong_compound = 0.12;
/// Two causes imitate a third the better the less of the gap is seen: of explanations with two that predicted
/// held-out readings of which noise is more than this share of the gap, on rough benches five of 21 were not
/// what was there (of ten in the catalogue's own world none); of 34 where it is less, none.
inline constexpr double tells_compounds = 0.1;

// ---- Levels ----

/// The level at which a gap is called present: of a hundred experiments without a gap one is called to have
/// one. Gaps of any use are far beyond it.
inline constexpr double gap_level = 0.01;
/// Below this p-value an explanation leaves structure, and is none: of a thousand right ones one is refused.
inline constexpr double fit_level = 0.001;
/// Two explanations whose log-likelihoods, or whose log-evidences, differ by less are not told apart: the
/// better one would be the wrong one in five of a hundred experiments (odds of twenty to one).
inline constexpr double told_apart = 3.0;

/// Where tolerances alone tell a value at each joint from one for all, or from one joint that stands out, and
/// the readings do not, the odds are those of a prior that is wide: of eight experiments in which one value
/// was named alone, and one at each joint had less evidence by up to this, five had the latter; of four in
/// which machining alone was named and one joint or link was the cause, three had no more.
inline constexpr double told_by_tolerances = 8;

/// So probable is it at least that another of a class is the cause than the best: of simulated experiments
/// whose class held the cause it was in ten of 39, and where the best was stated at more than 0.9 in one of
/// four.
inline constexpr double another_of_class = 0.2;

/// One explanation is named alone where of all listed ones it has so much at least: of 390 that were named
/// alone in four trials one had less, and was wrong.
inline constexpr double named_alone = 0.75;

/// A single effect with more values than this explains much that it is not: twelve rest angles of four runs
/// did a spring beside the chain, on a bench of another simulator.
inline constexpr unsigned too_many_values = 8;

/// A plainer explanation that closes so much of the gap that the best one closes (of the squares) stands
/// beside it: what is then left to the refinement is less than a tenth of the residual.
inline constexpr double closes_alike = 0.99;

/// A refinement of one effect stands beside the plainer one, however much less evidence it has, where chance
/// would give its further values so much likelihood in one experiment of so many.
inline constexpr double refines_by_chance = 0.01;

/// A gap that is so many times the noise shows more of a device than any model of it holds: what leaves less
/// than that share of it is an explanation.
inline constexpr double far_beyond = 50, tolerated_share = 0.15;
/// So many neighbouring readings share what a model leaves that is not exact: together they count as one.
inline constexpr double share_a_misfit = 8;

// ---- What held-out readings say of an explanation ----

/// They do not carry the gap where noise alone is more than this share of what is read there: not tested.
inline constexpr double carries_no_gap = 0.7;
/// They test nothing that is fitted without them where the parameters that are left open spread their
/// prediction by more than this share of the noise's variance: a right explanation would then miss them.
inline constexpr double undetermined = 0.5;

/// It predicts where it leaves at most so many times the noise.
inline constexpr double predicts = 1.5;
/// It may yet be another where it leaves so many times the noise, and by as much more than chance as a gap is
/// called one: on simulated experiments three of five that were identified wrongly left as much, and seven of
/// 76 that were right; of benches of another simulator with laws that differ from the catalogue's six of 16.
inline constexpr double clearly_more_than_noise = 1.07;
/// It is what was looked for, with a remainder, where it leaves at most so many times the noise, of a gap
/// whose noise floor is at most `clear`; so probable is another cause then. Of 334 that were identified in
/// three trials one left a remainder, clearly more than noise, and was wrong: such are hedged.
inline constexpr double nearly = 1.2, clear = 0.5, other_than_nearly = 0.05;
/// With so many values or more it is expected to leave no structure at all: a tare of each of two runs did
/// nearly what forces that cross over do.
inline constexpr unsigned many_to_leave_structure = 4;
/// Of explanations that did not predict, on simulated experiments, one in four was wrong; of those with two
/// effects eight of ten, which had a cause outside the catalogue (all four without what machining leaves); of
/// those with three, that predicted, all fifteen: eleven had such a cause, and of 16 with three, or of those
/// below, in three trials since, twelve.
inline constexpr double wrong_unpredicted = 0.25, wrong_unpredicted_compound = 0.8, wrong_three = 0.75;
/// What does not predict, and leaves more than this share of the squared gap of readings held out, is none:
/// on simulated experiments all four such had a cause outside the catalogue; of those in later trials, above.
inline constexpr double leaves_the_gap = 0.5, wrong_unshrunk = 0.75;

/// A law of a single joint closes the gap where it leaves no more than this of held-out readings, and others
/// come near it that leave so many times as much. Of 43 simulated single joints with a cause outside the
/// catalogue four were named so, and one of 62 others; of nine that laboratories measured, and whose gap
/// nothing explained, six. So there is as much to be said for another cause.
inline constexpr double closed = 0.25, closes_near = 1.25, wrong_single_joint = 0.5;

}  // namespace plumbline::diagnose::beliefs
