cli-more-time = { $cure }；延长时间：--time-limit S
