# made_up.R: answers that were made up from known effects, as `carom study export` writes them.

# Answers of people to 18 items in two of three forms: logit P = ability + item + gain * after + between * after * second arm.
madeUpTests <- function(people, gain, between, spreadOfPeople = 0.8, spreadOfItems = 0.7, arms = c("standing", "walking")) {
  forms <- c("A", "B", "C")
  orders <- list(c(1, 2), c(2, 3), c(3, 1), c(2, 1), c(3, 2), c(1, 3))
  items <- matrix(rnorm(18 * 3, 0, spreadOfItems), 18)
  ability <- rnorm(people, 0, spreadOfPeople)
  rows <- lapply(seq_len(people), function(i) {
    arm <- (i - 1) %% length(arms) + 1
    do.call(rbind, lapply(1:2, function(phase) {
      form <- orders[[((i - 1) %/% length(arms)) %% 6 + 1]][phase]
      log_odds <- ability[i] + items[, form] - 0.2 + (phase == 2) * (gain + between * (arm == 2))
      right <- rbinom(18, 1, plogis(log_odds))
      wrong <- c("light-late", "galilean", "absolute-time", "")[(seq_len(18) - 1) %% 4 + 1]
      data.frame(study = "Made up", participant = sprintf("P%04d", i), arm = arms[arm], order_row = (i - 1) %% 4, phase = kLevels[phase], form = forms[form],
                 item = paste0("item-", seq_len(18)), concept = paste0("concept-", (seq_len(18) + 1) %/% 2), position = seq_len(18),
                 answer = ifelse(right == 1, "key", "wrong"), correct = right, misconception = ifelse(right == 1, "", wrong),
                 confidence = pmin(4, pmax(1, round(2.5 + 0.6 * (log_odds > 0) + rnorm(18, 0, 0.8)))), seconds = round(rexp(18, 1 / 30), 1), changes = rpois(18, 0.2), reason = "")
    }))
  })
  do.call(rbind, rows)
}

# Returns the tests as the analysis reads them.
asRead <- function(rows) {
  rows$right <- rows$correct
  rows$sure <- rows$confidence
  rows$itemForm <- paste0(rows$item, "-", rows$form)
  rows$phase <- factor(rows$phase, kLevels[1:2])
  rows$arm <- factor(rows$arm, unique(rows$arm))
  rows
}

writeMadeUp <- function(folder, rows, facts = c(title = "Made up", seed = "1", primary = "gain between arms", bank = "shipped", withdrew = "1"), excluded = "") {
  dir.create(folder, showWarnings = FALSE)
  ratings <- do.call(rbind, lapply(unique(rows$participant), function(p) {
    one <- rows[rows$participant == p, ][1, ]
    one <- one[rep(1, 2), ]
    transform(one, phase = "rating", form = "", item = c("unwell-before", "unwell-after"), concept = "", answer = c(0, 2), correct = "", misconception = "", confidence = "")
  }))
  write.csv(rbind(rows, ratings), file.path(folder, "responses.csv"), row.names = FALSE, quote = FALSE)
  people <- unique(rows[c("study", "participant", "arm", "order_row")])
  write.csv(cbind(people, excluded = excluded), file.path(folder, "participants.csv"), row.names = FALSE, quote = FALSE)
  write.csv(data.frame(key = names(facts), value = facts), file.path(folder, "study.csv"), row.names = FALSE)
}
