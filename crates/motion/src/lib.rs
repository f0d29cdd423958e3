//! Program and machine to time: joint paths, the speed law, set-points, textbook interpolators.
