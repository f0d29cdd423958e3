cli-more-time = { $cure }; more time: --time-limit S
