package frustum.driver.scene

/** What was skipped, replaced or not drawn, so that the rest could be used.
  *
  * @param what  is the case, with the place of the first of its kind, what was done about it and the remedy
  * @param count how often it was met
  */
final case class Notice(what: String, count: Long) {
  override def toString: String = s"notice: $what ($count)"
}
