cli-more-time = { $cure }; mehr Zeit: --time-limit S
