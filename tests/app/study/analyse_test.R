# analyse_test.R ANALYSE MADE_UP [SETS]: the analysis of studies on made-up answers. With a known effect its intervals cover it about
# 95 % of the time, without one about 5 % of the sets are called significant; its numbers agree with others' ways to them.

arguments <- commandArgs(TRUE)
source(arguments[1]); source(arguments[2])
sets <- if (length(arguments) > 2) as.integer(arguments[3]) else 20
kBetween <- 0.6; kGain <- 0.8
failed <- FALSE
expect <- function(holds, ...) if (!isTRUE(holds)) { failed <<- TRUE; cat("FAILED:", ..., "\n") }

# The true difference between the arms in the mean change, in points: the mean of the logistic over people and items (both normal).
meanRight <- function(shift, spread = sqrt(0.8^2 + 0.7^2)) integrate(function(x) plogis(x * spread - 0.2 + shift) * dnorm(x), -8, 8)$value
trueChange <- 100 * (meanRight(kGain + kBetween) - meanRight(kGain))

tryModel <- function(seed, between) {
  set.seed(seed)
  tests <- asRead(madeUpTests(48, kGain, between))
  row <- mixedModel(tests)$rows
  row <- row[row$term == interactionTerm(tests), ]
  boot <- effectsOf(scoresOf(tests), seed, 2000)
  boot <- boot[boot$outcome == "change between arms", ]
  c(covers = row$low <= between && between <= row$high, significant = row$p < 0.05,
    bootCovers = boot$low <= trueChange && trueChange <= boot$high, estimate = row$estimate)
}
with <- vapply(seq_len(sets), tryModel, numeric(4), between = kBetween)
without <- vapply(1000 + seq_len(sets), tryModel, numeric(4), between = 0)
covered <- mean(with["covers", ]); bootCovered <- mean(with["bootCovers", ]); called <- mean(without["significant", ])
cat(sprintf("%d sets of 48 people: the model's interval covers %g %%, the bootstrap's %g %%; without an effect %g %% are called significant; mean estimate %.3f of %g\n",
            sets, 100 * covered, 100 * bootCovered, 100 * called, mean(with["estimate", ]), kBetween))
# Twenty sets tell only gross errors: of 20, fewer than 16 are covered, or more than 4 significant, in 3 of 1000 runs.
if (sets >= 200) {
  expect(covered >= 0.9 && covered <= 0.99, "coverage", covered)
  expect(bootCovered >= 0.9 && bootCovered <= 0.99, "coverage of the bootstrap", bootCovered)
  expect(called >= 0.03 && called <= 0.08, "significant without an effect", called)
} else {
  expect(covered >= 0.8 && bootCovered >= 0.8, "coverage", covered, bootCovered)
  expect(called <= 0.2, "significant without an effect", called)
}
if (sets > 3) expect(abs(mean(with["estimate", ]) - kBetween) < 4 * sd(with["estimate", ]) / sqrt(sets), "the estimates' mean")

# By other ways: closed forms, and what R has itself.
pre <- c(20, 40, 60, 100); post <- c(50, 40, 80, 100)
one <- armStatistics(matrix(pre), matrix(post))
expect(abs(one$gain - (67.5 - 55) / 45) < 1e-12, "gain of the means", one$gain)
expect(abs(one$gains - mean(c(30 / 80, 0, 20 / 40))) < 1e-12, "mean of gains, without the one who had everything right")
expect(abs(one$g - 12.5 / sd(post - pre) * (1 - 3 / 11)) < 1e-12, "Hedges' g of the change")
set.seed(4)
a <- rnorm(15, 50, 10); b <- rnorm(12, 60, 12)
g <- betweenArms(armStatistics(matrix(0 * a), matrix(a)), armStatistics(matrix(0 * b), matrix(b)))$g
t <- unname(t.test(b, a, var.equal = TRUE)$statistic) # d = t sqrt(1/n + 1/m)
expect(abs(g - t * sqrt(1 / 15 + 1 / 12) * (1 - 3 / (4 * 25 - 1))) < 1e-12, "Hedges' g between arms")
x <- matrix(rbinom(30 * 6, 1, plogis(rnorm(30))), 30)
alpha <- 6 / 5 * (1 - sum(apply(x, 2, var)) / var(rowSums(x))) # Cronbach's, which is KR-20 for right and wrong
expect(abs(kr20(x) - alpha) < 1e-12, "KR-20", kr20(x), alpha)
tests <- data.frame(participant = rep(sprintf("p%d", 1:9), 2), phase = rep(c("pre", "post"), each = 9), misconception = "m", right = 0,
                    sure = c(rep(4, 8), 1, rep(1, 7), 4, 4))
sure <- sureAndWrong(tests) # 7 lost it, 1 got it: p = 2 (1 + 8) / 2^8
expect(sure$before == 8 && sure$after == 2 && sure$lost == 7 && sure$got == 1 && abs(sure$p - 18 / 256) < 1e-12, "McNemar's test", unlist(sure))
two <- armStatistics(matrix(c(20, 40)), matrix(c(50, 60)))
expect(is.na(two$g) && num(two$g) == "&ndash;", "Hedges' g of two people, of which nothing is known", two$g)
small <- data.frame(participant = letters[1:4], arm = factor(c("a", "a", "b", "b")), pre = c(20, 40, 20, 40), post = c(50, 70, 60, 80))
g <- effectsOf(small, 1, 200); g <- g[g$outcome == "g between arms", ] # each arm changes alike: no spread, no g
expect(nrow(g) == 1 && is.na(g$estimate) && is.na(g$low), "g between arms of an interval without width", unlist(g))
small$post <- c(50, 71, 60, 80) # one pair differs: the samples that have a spread have the same g, or none
g <- effectsOf(small, 1, 200); g <- g[g$outcome == "g between arms", ]
expect(is.na(g$estimate) || g$low < g$high, "g between arms", unlist(g))
items <- data.frame(participant = rep(letters[1:6], 4), phase = rep(rep(c("pre", "post"), each = 6), 2), form = "A", concept = "k", item = rep(c("i", "j"), each = 12))
items$itemForm <- paste0(items$item, "-A")
items$right <- c(0, 0, 0, 1, 1, 1,  0, 1, 0, 1, 0, 1,  0, 0, 1, 1, 1, 1,  1, 0, 1, 0, 1, 0) # i before, i after, j before, j after
found <- itemStatistics(items)
expect(all(found$n == 6), "the items' table counts people", found$n)
expect(abs(found$apartBefore[1] - cor(items$right[1:6], items$right[13:18])) < 1e-12 && abs(found$apartAfter[1] + 1) < 1e-12, "discrimination of each test", unlist(found[1, ]))
seen <- data.frame(participant = c("p", "p", "q", "q", "r"), lesson = c("l", "l", "l", "m", "l"), explained = c("0", "1", "1", "0", "1"))
expect(identical(unexplainedBy(seen), "q"), "people whose lesson did not explain itself", unexplainedBy(seen))
expect(num(-1.5) == "&minus;1.50" && esc("<a \"&\">") == "&lt;a &quot;&amp;&quot;&gt;", "words of the page")

# Whole reports.
work <- tempfile("carom-report-")
report <- function(name, people, arms = c("standing", "walking"), facts = NULL, change = identity, ...) {
  set.seed(7)
  folder <- file.path(work, name)
  dir.create(work, showWarnings = FALSE)
  rows <- change(madeUpTests(people, kGain, kBetween, arms = arms))
  if (is.null(facts)) writeMadeUp(folder, rows, ...) else writeMadeUp(folder, rows, facts, ...)
  began <- proc.time()["elapsed"]
  analyse(folder)
  list(page = paste(readLines(file.path(folder, "report.html"), warn = FALSE), collapse = "\n"), results = read.csv(file.path(folder, "results.csv")), seconds = proc.time()["elapsed"] - began)
}
says <- function(page, ...) for (words in c(...)) expect(grepl(words, page, fixed = TRUE), "the report does not say:", words)
few <- report("few", 11, excluded = c(rep("", 8), "unfinished", "stopped", "unfinished"))
says(few$page, "Description only", "1 withdrew", "1 stopped: P0010", "2 had not finished: P0009, P0011")
expect(all(is.na(few$results$p)), "p-values of 8 people")
many <- report("many", 48)
says(many$page, "<h2>People</h2>", "<h2>Each arm</h2>", "<h2>Between the arms</h2>", "<h2>Mixed model</h2>", "<h2>Items</h2>", "<h2>Sure and wrong</h2>", "<h2>Confidence and correctness</h2>",
     "<h2>Ratings</h2>", "<svg", "unvalidated", "(primary)", "KR-20", "1 withdrew")
expect(!grepl("Description only", many$page), "48 people are enough")
expect(!grepl("(src|href)=|url\\(|@import|https?:", many$page), "the report asks for something from outside")
expect(sum(many$results$primary) == 1 && is.na(many$results$p_holm[many$results$primary == 1]), "one primary outcome, not corrected")
others <- many$results[!is.na(many$results$p) & many$results$primary == 0, ]
expect(all(others$p_holm >= others$p) && nrow(others) > 3, "all others are corrected")
single <- report("single", 24, "class", c(title = "One <arm>", seed = "1", primary = "gain", bank = "own"))
says(single$page, "One &lt;arm&gt;", "The items are of the study's own bank")
expect(!grepl("unvalidated", single$page), "says of another bank that it is unvalidated")
says(many$page, "The items of the shipped bank are <b>unvalidated</b>")
expect(any(single$results$primary == 1 & single$results$outcome == "odds ratio phasepost"), "the gain of one arm is the primary outcome")
alike <- report("alike", 24, change = function(rows) transform(rows, correct = as.integer((as.integer(factor(item)) + as.integer(factor(participant)) * 7 + (phase == "post")) %% 2)))
says(alike$page, "Singular fit")
perfect <- report("perfect", 24, change = function(rows) transform(rows, correct = ifelse(participant == "P0003" & phase == "pre", 1, correct)))
says(perfect$page, "1 had everything right before and have no gain of their own: P0003")
hundred <- report("hundred", 100)
cat(sprintf("a report of 100 people took %.1f s\n", hundred$seconds))
if (length(arguments) > 3) invisible(file.copy(file.path(work, c("many", "few")), arguments[4], recursive = TRUE))
quit(status = if (failed) 1 else 0)
