//! Job files; seam, joint and procedure to passes: torch attitude and checks.
