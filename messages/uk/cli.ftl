cli-more-time = { $cure }; більше часу: --time-limit S
